#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/fields/material_field.h"
#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/macro/layer_code.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// The G-code of a layer, and what it takes, for each pass that prints something in it (and pass 0
/// of a layer that prints nothing):
///   1 moves of each block, once for all its copies (toolpath_builder.h, flow_smoothing.h)
///   2 slow-down over the whole layer, and fan (cooling.h)
///   3 times (layer_timing.h), and the moves at both ends (edge_moves.h)
///   4 text, each copy with its shift and label (layer_writer.h, object_labels.h)
///
/// A program starts retracted, or ready to print if the layer begins so, at the height of the layer
/// below or over its entry, with relative E and absolute coordinates, and ends so; so does each
/// copy in it. It depends on nothing but its
/// arguments: programs are joined by concatenation. A copy's text depends on its place only by that
/// shift. A layer without paths moves nothing, but still says that it is a layer. Times: the layer
/// begins and ends at rest; the travel to its entry is not counted, the one up to its height is
/// (print_clock.h puts that right).
/// With a pass for each copy, the layers of a pass are counted as the copy's own (layer_place.h);
/// the way from pass to pass is no part of them (pass_change.h).
/// `code`: the options' templates, parsed. What depends on the layers before is left out, and its
/// places are told (LayerProgram::code_at).
/// `materials`: that of options.material_field, read; null: nothing is mixed.
/// Errors: those of the settings' templates (template_run.h). REQUIRES: CheckOptions and
/// CheckLayer hold.
absl::StatusOr<std::vector<LayerProgram>> ProgramLayer(const OrderedLayer& layer,
                                                       const JobFacts& facts,
                                                       const MotionOptions& options,
                                                       const LayerCode& code,
                                                       const MaterialField* materials = nullptr);

}  // namespace slicefarm::motion
