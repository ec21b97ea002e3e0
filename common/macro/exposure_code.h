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

/// The templates of the G-code that exposes, parsed.
struct ExposureCode {
  Template start;
  Template before_layer;
  Template layer;
  Template end;
};

/// Errors: those of ParseTemplate.
absl::StatusOr<ExposureCode> ParseExposureCode(const ExposureOutput& output);

/// Before any work: whether each name in the templates that may be read exists, and operands fit.
/// Of formats that are no G-code nothing is read: a profile's templates may be of another machine.
/// `settings_text`: the effective settings. Errors: SETTING_MALFORMED naming the setting.
absl::Status CheckExposureCode(const ExposureOutput& output, std::string_view settings_text);

/// What templates may name besides settings:
///   total_layer_count, max_print_z, print_time    of the whole print; the time as "1h 2m 3s"
///   first_layer_print_min, _max, _size            of all that is exposed, [0] x and [1] y in mm
///   model_name, input_filename_base               of the first object
TemplateVariables ExposurePrintVariables(const ExposureSummary& summary);
///   layer_num      from 0; -1 in start_gcode
///   layer_z        upper side of the layer in mm
///   max_layer_z    of the layers so far
TemplateVariables ExposureLayerVariables(int32_t number, Coord z_nm);

}  // namespace slicefarm::macro
