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

/// Returns the G-code of a layer and its cost, one program for each pass that prints something in
/// the layer. A layer that prints nothing gives one program, for pass 0. Steps:
///   1 moves of each block, once for all its copies (toolpath_builder.h, flow_smoothing.h).
///   2 slow-down over the whole layer, and fan (cooling.h).
///   3 times (layer_timing.h), and the moves at both ends (edge_moves.h).
///   4 text, each copy with its shift and label (layer_writer.h, object_labels.h).
///
/// A program starts with the filament retracted, or ready to print if OrderedLayer::begins_ready is
/// true. It starts at the height of the layer below or above its entry, with relative E and
/// absolute coordinates. It ends in this state, and so does each copy in it. A program depends on
/// the arguments only, so programs are joined by concatenation. Two copies of a block have the same
/// text except for their shift. A layer without paths has no moves but still has a layer comment.
///
/// Times: the machine stands still before and after the layer. The travel to the layer's entry is
/// not counted, but the move up to its height is (print_clock.h corrects both).
///
/// If each copy is a pass of its own, layers are counted per copy (layer_context.h). The travel
/// between passes belongs to neither pass (pass_change.h).
///
/// `code`: the options' parsed templates. Templates that depend on earlier layers are left out, and
/// their positions are returned (LayerProgram::code_at). `materials`: options.material_field as a
/// field; null turns mixing off. Errors: any error of the settings' templates (template_run.h).
/// REQUIRES: CheckOptions and CheckLayer succeed.
absl::StatusOr<std::vector<LayerProgram>> ProgramLayer(const OrderedLayer& layer,
                                                       const JobFacts& facts,
                                                       const MotionOptions& options,
                                                       const LayerCode& code,
                                                       const MaterialField* materials = nullptr);

}  // namespace slicefarm::motion
