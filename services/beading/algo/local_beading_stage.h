#pragma once

#include <memory>

#include "common/stage/stages.h"

namespace slicefarm::beading {

/// Constant-width walls with variable-width gap fill, worked out island by island; see README.md.
/// Stateless; looks at the layers of the range only, the halo is ignored.
/// Errors: Cancelled, polled once a layer and a gap; InvalidArgument with SETTING_OUT_OF_RANGE for
/// widths that are not above their layer's height times 1 - pi/4 (no spacing is left).
std::unique_ptr<BeadingStage> MakeLocalBeading();

}  // namespace slicefarm::beading
