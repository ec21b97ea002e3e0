#pragma once

#include <memory>

#include "common/stage/infill_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::infill {

/// Returns the infill stage that runs in this program. It fills each section of each layer
/// (section_fill.h); see README.md. The stage has no state. A section's result depends only on its
/// own walls and on the object's outlines in the layers that its skins reach. The division of a job
/// into ranges therefore does not matter.
///
/// Errors: Cancelled (checked once per section). REQUEST_MALFORMED if an area refers to settings
/// that are not in the table, or if there is not one plan per layer. SETTING_MALFORMED for a text
/// that is not a field. All errors of FillSection.
std::unique_ptr<InfillStage> MakeLocalInfill();

}  // namespace slicefarm::infill
