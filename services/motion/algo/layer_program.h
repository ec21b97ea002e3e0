#pragma once

#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "common/model/motion_options.h"

namespace slicefarm::motion {

/// The G-code of a layer, and what it takes:
///   1 moves (toolpath_builder.h)
///   2 slow-down and fan (cooling.h)
///   3 times (layer_timing.h)
///   4 text (layer_writer.h)
///
/// It starts retracted, anywhere at the height of the layer below or above it, with relative E and
/// absolute coordinates, and ends so. It depends on nothing but its arguments: programs are joined
/// by concatenation. A layer without paths moves nothing, but still says that it is a layer. Times:
/// the layer begins and ends at rest; the travel to its entry is not counted, the one up to its
/// height is. Errors: those of the settings' templates (gcode_template.h). REQUIRES: CheckOptions
/// and CheckLayer hold.
absl::StatusOr<LayerProgram> ProgramLayer(const OrderedLayer& layer, const MotionOptions& options);

}  // namespace slicefarm::motion
