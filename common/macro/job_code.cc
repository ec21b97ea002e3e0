#include "common/macro/job_code.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "common/base/error.h"
#include "common/macro/setting_variables.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::macro {
namespace {

constexpr std::string_view kClock[] = {"timestamp", "year",   "month", "day",
                                       "hour",      "minute", "second"};

template <typename Test>
bool AnyName(const Template& code, const Test& test) {
  return std::ranges::any_of(NamesIn(code), test);
}

/// Returns all templates of the job except change_extrusion_role_gcode, which has variables of its
/// own.
std::array<const Template*, 11> PartsOf(const JobCode& code) {
  return {&code.file_start,      &code.start,        &code.start_filament, &code.before_layer,
          &code.layer,           &code.color_change, &code.pause,          &code.at_height,
          &code.between_objects, &code.end,          &code.file_name};
}

/// Returns true if the variable is unknown while a layer is made. The number of layers is known
/// beforehand.
bool Waits(const std::string& name) { return WaitsForLayers(name) && name != "total_layer_count"; }

/// Returns the variables of change_extrusion_role_gcode that are no settings. Its text is made with
/// the layer, so variables that wait are not among them.
TemplateVariables VariablesOfRoles() {
  TemplateVariables variables = VariablesOfThePrint();
  std::erase_if(variables, [](const auto& variable) { return Waits(variable.first); });
  variables["extrusion_role"] = variables["last_extrusion_role"] = std::string();
  return variables;
}

/// Returns the error of a check of change_extrusion_role_gcode. If the unknown name is a variable
/// of other templates, says why it is unknown here.
absl::Status OfRoles(const absl::Status& error) {
  ErrorDetail detail = DetailOf(error);
  const auto variable = detail.metadata.find("variable");
  if (variable == detail.metadata.end() || !Waits(variable->second)) return error;
  return MakeError(error.code(), detail.reason,
                   fmt::format("{}: the print determines {} only after its layers are made",
                               std::string(error.message()), variable->second),
                   std::move(detail.metadata));
}

bool LayersWait(const JobCode& code) {
  std::set<std::string> globals;
  for (const Template* part :
       {&code.start, &code.start_filament, &code.before_layer, &code.layer, &code.between_objects,
        &code.color_change, &code.pause, &code.at_height})
    globals.merge(GlobalsOf(*part));
  const auto waits = [&](const std::string& name) { return globals.contains(name) || Waits(name); };
  return AnyName(code.before_layer, waits) || AnyName(code.layer, waits) ||
         AnyName(code.color_change, waits) || AnyName(code.pause, waits) ||
         AnyName(code.at_height, waits);
}

}  // namespace

absl::StatusOr<JobCode> ParseJobCode(const MotionOptions& options) {
  JobCode code;
  const TemplateTarget targets[] = {
      {"start_gcode", options.start_gcode.str(), code.start},
      {"start_filament_gcode", options.tool().start_filament_gcode.str(), code.start_filament},
      {"before_layer_gcode", options.before_layer_gcode.str(), code.before_layer},
      {"layer_gcode", options.layer_gcode.str(), code.layer},
      {"change_extrusion_role_gcode", options.role_gcode.str(), code.role},
      {"file_start_gcode", options.file_start_gcode.str(), code.file_start},
      {"between_objects_gcode", options.between_objects_gcode.str(), code.between_objects},
      {"end_gcode", options.end_gcode.str(), code.end},
      {"output_filename_format", options.writing.file_name, code.file_name},
      {"color_change_gcode", options.writing.color_change_gcode.str(), code.color_change},
      {"pause_print_gcode", options.writing.pause_gcode.str(), code.pause},
      {"template_custom_gcode", options.writing.template_gcode.str(), code.at_height}};
  // The last three templates are only used by custom_gcode_per_print_z.
  const size_t count = std::size(targets) - (options.writing.height_code.empty() ? 3 : 0);
  if (absl::Status status = ParseTemplates(std::span(targets).first(count)); !status.ok())
    return status;
  code.layers_wait = LayersWait(code);
  return code;
}

absl::Status CheckJobCode(const MotionOptions& options, std::string_view settings_text) {
  const auto code = ParseJobCode(options);
  if (!code.ok()) return code.status();
  TemplateVariables settings;
  AddSettingVariables(settings_text, settings);
  const TemplateVariables print = VariablesOfThePrint();
  const TemplateScope scope = {settings, print};
  TemplateMemory memory;
  const TemplateVariables roles = VariablesOfRoles();
  TemplateMemory of_roles;
  if (absl::Status status = CheckTemplate(code->role, {settings, roles}, of_roles); !status.ok())
    return OfRoles(status);
  for (const Template* part : PartsOf(*code))
    if (absl::Status status = CheckTemplate(*part, scope, memory); !status.ok()) return status;
  return absl::OkStatus();
}

bool NamesClock(const JobCode& code) {
  const auto is_clock = [](const std::string& name) {
    return std::ranges::find(kClock, name) != std::end(kClock);
  };
  return AnyName(code.role, is_clock) ||
         std::ranges::any_of(PartsOf(code),
                             [&](const Template* part) { return AnyName(*part, is_clock); });
}

}  // namespace slicefarm::macro
