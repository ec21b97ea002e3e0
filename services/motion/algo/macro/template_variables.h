#pragma once

#include "common/model/job_facts.h"
#include "common/model/layer.h"
#include "common/model/options/motion_options.h"
#include "common/model/program_summary.h"
#include "services/motion/algo/macro/template_value.h"
#include "services/motion/algo/toolpath/layer_place.h"

namespace slicefarm::motion {

/// What the templates of a layer may name: settings by their names in a config.ini (those of
/// motion, those in `layer_settings`, and TemplateDefaults() for what was not given), the extruder
/// in use, layer_num over all passes, layer_z and max_layer_z, the highest so far (mm),
/// current_object_idx, the number of the pass, and total_layer_count if the facts have it: as
/// planned, with layers at the very top that turn out to be too thin for a bead.
TemplateVariables LayerVariables(const MotionOptions& options, const JobFacts& facts,
                                 const LayerPlace& place);

/// What start and end G-code may name: the same, with all settings that the summary quotes, and
/// what is known of the whole print:
///   total_layer_count, max_layer_z, layer_num and layer_z of the last layer, current_object_idx 0
///   print_bed_min / _max / _size, of the setting bed_shape if the summary quotes it
///   first_layer_print_min / _max / _size, of all layers, which hold the first
///   used_filament (m), extruded_volume (mm^3), total_weight (g), total_cost
///   print_time, as "1h 2m 3s"; time_s is that of the layers
///   num_objects, input_filename, input_filename_base
TemplateVariables ProgramVariables(const MotionOptions& options, const ProgramSummary& summary,
                                   double time_s);

}  // namespace slicefarm::motion
