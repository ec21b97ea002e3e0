#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_value.h"
#include "common/model/layers/layer.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {
struct ExposureOutput;
}  // namespace slicefarm

namespace slicefarm::macro {

/// Parsed templates of the G-code of an exposure.
struct ExposureCode {
  Template start;
  Template before_layer;
  Template layer;
  Template end;
};

/// Parses the templates. Errors: any error of ParseTemplate.
absl::StatusOr<ExposureCode> ParseExposureCode(const ExposureOutput& output);

/// Checks the templates before any work: all names in parts that may run must exist, and operands
/// must have valid types. Templates of an output format other than G-code are not checked, because
/// a profile may contain templates for another machine. `settings_text`: the effective settings.
/// Errors: SETTING_MALFORMED naming the setting.
absl::Status CheckExposureCode(const ExposureOutput& output, std::string_view settings_text);

/// Returns the variables of the whole print, besides settings:
///   total_layer_count, max_print_z, print_time    of the whole print; the time as "1h 2m 3s"
///   first_layer_print_min, _max, _size            of the exposed area, [0] x and [1] y in mm
///   model_name, input_filename_base               name of the first object
TemplateVariables ExposurePrintVariables(const ExposureSummary& summary);
/// Returns the variables of a layer:
///   layer_num      number from 0; -1 in start_gcode
///   layer_z        upper side of the layer in mm
///   max_layer_z    highest upper side of the layers so far, in mm
TemplateVariables ExposureLayerVariables(int32_t number, Coord z_nm);

}  // namespace slicefarm::macro
