#pragma once

#include <optional>

#include "common/macro/template_value.h"
#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/toolpath/layer_place.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// What templates may name at any place of a job: settings by their names in a config.ini (those
/// of motion, those in `settings_text`, and PrusaSlicer's defaults of what was not given), and the
/// tool in use (setting_variables.h).
macro::TemplateVariables JobVariables(const MotionOptions& options, std::string_view settings_text);

/// What they may name in a layer: layer_num over all passes, layer_z and max_layer_z, the highest
/// so far (mm), current_object_idx, the number of the pass, and total_layer_count if the facts have
/// it: as planned, with layers at the very top that turn out to be too thin for a bead.
macro::TemplateVariables LayerVariables(const LayerPlace& place, const JobFacts& facts);

/// What is known once all layers are:
///   total_layer_count
///   first_layer_print_min / _max / _size and first_layer_print_convex_hull, of what the first
///   layer covers
///   used_filament (m), extruded_volume (mm^3), total_weight (g), total_cost
///   print_time, as "1h 2m 3s"; time_s is that of the layers. silent_print_time is silent_s, if the
///   machine has a silent mode
///   num_objects, num_instances, input_filename, input_filename_base
macro::TemplateVariables PrintVariables(const MotionOptions& options, const ProgramSummary& summary,
                                        double time_s, std::optional<double> silent_s = {});

/// Puts extruded_volume, extruded_weight and their totals: of what was printed before.
void PutUseSoFar(const MotionOptions& options, double filament_mm,
                 macro::TemplateVariables& variables);

}  // namespace slicefarm::motion
