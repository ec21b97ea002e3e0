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

/// Parsed G-code templates of a job.
struct JobCode {
  Template start;
  Template start_filament;
  Template before_layer;
  Template layer;
  Template role;  ///< `change_extrusion_role_gcode`
  Template file_start;
  Template between_objects;
  Template end;
  Template color_change;
  Template pause;
  Template at_height;  ///< `template_custom_gcode`
  Template file_name;
  /// True if before_layer_gcode or layer_gcode depends on earlier layers or on global variables.
  /// Then both are expanded after all layers exist, in the order of the layers.
  bool layers_wait = false;
};

/// Parses the templates. Errors: any error of ParseTemplate.
absl::StatusOr<JobCode> ParseJobCode(const MotionOptions& options);

/// Checks the templates before any work: all names in parts that may run must exist, and operands
/// must have valid types. `settings_text`: text of the job's effective settings. Errors:
/// SETTING_MALFORMED naming the setting.
absl::Status CheckJobCode(const MotionOptions& options, std::string_view settings_text);

/// Returns true if a template of the job uses the creation time.
bool NamesClock(const JobCode& code);

}  // namespace slicefarm::macro
