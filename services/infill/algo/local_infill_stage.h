#pragma once

#include <memory>

#include "common/stage/stages.h"

namespace slicefarm::infill {

/// Skins from the neighbouring layers, then lines for each kind of region; see README.md.
/// Stateless. A layer's result depends on its own walls and on the outlines of the layers that its
/// skins reach, so not on how a job is cut into ranges. Errors: Cancelled, polled once a layer;
/// those of CheckSpacing for the layer's widths, and of CutLines.
std::unique_ptr<InfillStage> MakeLocalInfill();

}  // namespace slicefarm::infill
