#pragma once

#include <memory>

#include "common/stage/beading_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::beading {

/// Returns the stage that makes the walls of each island of each region, see
/// docs/algorithms/walls.md. Walls of kArachne depend on the object's outlines in
/// kBeadingHaloLayers layers above and below. Walls of kClassic depend on their own layer, unless
/// one_on_top or extra_perimeters (BeadingOptions) make them depend on the layers directly above
/// and below. The stage has no state.
///
/// Errors: Cancelled (checked once per section and gap). InvalidArgument with SETTING_OUT_OF_RANGE
/// for a wall width of at most (1 - pi/4) times the layer's height: the spacing would not be
/// positive. REQUEST_MALFORMED for a region with settings in no table, or with a tool other than 0.
std::unique_ptr<BeadingStage> MakeLocalBeading();

}  // namespace slicefarm::beading
