#pragma once

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Checks that planners can use the options. Diameters and speeds must be above 0, numbers finite,
/// and lengths at most 10 m. The settings are checked in full where they are read; this check
/// limits the damage of a faulty sender. Errors: InvalidArgument SETTING_OUT_OF_RANGE naming the
/// setting.
absl::Status CheckOptions(const MotionOptions& options);

/// Checks the paths, blocks and visits of a layer.
/// - Paths: at least two points, the right number of widths, and a width, height and position that
///   a printer can have. Path::settings must be a valid index, and the tool must be 0.
/// - Blocks: at least one path.
/// - Visits: a valid index of a block, and a shift in whole micrometres. Passes must ascend.
///   Errors: InvalidArgument REQUEST_MALFORMED naming the layer. Cost: O(points + visits).
absl::Status CheckLayer(const OrderedLayer& layer, const MotionOptions& options);

}  // namespace slicefarm::motion
