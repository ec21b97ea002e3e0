#pragma once

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Refuses what no planner can work with: diameters and speeds that are not above 0, numbers that
/// are not finite, lengths beyond 10 m. Settings are checked in full where they are read; this
/// keeps a wrong sender from doing harm. Errors: InvalidArgument SETTING_OUT_OF_RANGE naming the
/// setting.
absl::Status CheckOptions(const MotionOptions& options);

/// Refuses paths of fewer than two points, with a wrong number of widths, of a width, height or
/// place that no printer has, whose settings are in no table, or with a tool other than 0; blocks
/// without paths; visits of no block, or whose shift is not in whole micrometres; passes that do
/// not ascend. Errors: InvalidArgument REQUEST_MALFORMED naming the layer. Cost: O(points +
/// visits).
absl::Status CheckLayer(const OrderedLayer& layer, const MotionOptions& options);

}  // namespace slicefarm::motion
