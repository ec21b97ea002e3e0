#pragma once

#include <memory>

#include "common/stage/infill_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::infill {

/// Fills each section of each layer (section_fill.h); see README.md. Stateless. A section's result
/// depends on its own walls and on the object's outlines in the layers that its skins reach, so not
/// on how a job is cut into ranges. Errors: Cancelled, polled once a section; REQUEST_MALFORMED for
/// areas whose settings are in no table; those of FillSection.
std::unique_ptr<InfillStage> MakeLocalInfill();

}  // namespace slicefarm::infill
