#pragma once

#include <memory>

#include "common/stage/infill_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::infill {

/// Returns the infill stage that runs in this process. It fills each section of each layer
/// (section_fill.h); see docs/algorithms/skins-and-bridges.md and infill-linking.md. Stateless. A
/// section's result depends only on its own walls and on the object's outlines in the layers that
/// its skins reach. The division of a job into ranges
/// therefore does not matter. Errors: Cancelled, polled once per section; REQUEST_MALFORMED for
/// areas with settings that are in no table; errors of FillSection.
std::unique_ptr<InfillStage> MakeLocalInfill();

}  // namespace slicefarm::infill
