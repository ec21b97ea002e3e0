#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_run.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::macro {

/// The G-code templates of a job, parsed.
struct JobCode {
  Template start;
  Template start_filament;
  Template before_layer;
  Template layer;
  Template between_objects;
  Template end;
  Template color_change;
  Template pause;
  Template at_height;  ///< template_custom_gcode
  Template file_name;
  /// before_layer_gcode or layer_gcode depends on what was printed before, or on global variables:
  /// they are filled in when all layers are there, in their order.
  bool layers_wait = false;
};

/// Errors: those of ParseTemplate.
absl::StatusOr<JobCode> ParseJobCode(const MotionOptions& options);

/// Before any work: whether each name in the templates that may be read exists, and operands fit.
/// `settings_text`: the effective settings. Errors: SETTING_MALFORMED naming the setting.
absl::Status CheckJobCode(const MotionOptions& options, std::string_view settings_text);

/// Whether a template of the job names the time of its creation.
bool NamesClock(const JobCode& code);

}  // namespace slicefarm::macro
