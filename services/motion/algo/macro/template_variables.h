#pragma once

#include <optional>

#include "common/macro/template_value.h"
#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/toolpath/layer_context.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns the variables that templates may use anywhere in a job: the settings under their names
/// in a config.ini, and the tool in use (setting_variables.h). Settings are the motion options, the
/// settings in `settings_text`, and PrusaSlicer's defaults for all others.
macro::TemplateVariables JobVariables(const MotionOptions& options, std::string_view settings_text);

/// Returns the variables of templates in a layer:
/// - layer_num, index of the layer, counted over all passes;
/// - layer_z, the height of the layer's top (mm);
/// - max_layer_z, the greatest height printed so far (mm);
/// - current_object_idx, the index of the pass;
/// - total_layer_count, only if the facts have it. This planned number includes top layers that
///   turn out to be too thin for a bead.
macro::TemplateVariables LayerVariables(const LayerContext& context, const JobFacts& facts);

/// Returns the variables that are known after all layers:
/// - total_layer_count;
/// - first_layer_print_min, _max, _size and _convex_hull, the area of the first layer;
/// - used_filament (m), extruded_volume (mm^3), total_weight (g), total_cost;
/// - print_time, as "1h 2m 3s", from `time_s`, the time of the layers;
/// - silent_print_time, from `silent_s`, if the machine has a silent mode;
/// - num_objects, num_instances, input_filename, input_filename_base.
macro::TemplateVariables PrintVariables(const MotionOptions& options, const ProgramSummary& summary,
                                        double time_s, std::optional<double> silent_s = {});

/// Sets the variables for the print so far:
/// - extruded_volume, extruded_weight and their totals;
/// - curr_accumulated_mass and curr_layer_mass (g), the latter of the layer printed last;
/// - curr_y_acceleration_limit (mm/s^2): machine_max_acceleration_y, or less if machine_max_force_y
///   accelerates the bed and the print so far less.
/// `filament_mm`: filament so far; `layer_mm`: its part in the layer printed last.
void PutUseSoFar(const MotionOptions& options, double filament_mm, double layer_mm,
                 macro::TemplateVariables& variables);

}  // namespace slicefarm::motion
