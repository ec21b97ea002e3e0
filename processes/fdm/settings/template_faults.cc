#include "processes/fdm/settings/template_faults.h"

#include <string>

#include "common/base/error.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns the template of a setting that a job does not need, or nullptr.
SharedText* TemplateOf(const std::string& setting, FdmRows& rows) {
  MachineMotion& motion = rows.machine.motion;
  if (setting == "start_filament_gcode") return &rows.tool.start_filament_gcode;
  if (setting == "before_layer_gcode") return &motion.before_layer_gcode;
  if (setting == "layer_gcode") return &motion.layer_gcode;
  if (setting == "between_objects_gcode") return &motion.between_objects_gcode;
  if (setting == "color_change_gcode") return &motion.writing.color_change_gcode;
  if (setting == "pause_print_gcode") return &motion.writing.pause_gcode;
  if (setting == "template_custom_gcode") return &motion.writing.template_gcode;
  return nullptr;
}

}  // namespace

bool LeaveOutTemplate(const absl::Status& fault, const SettingValues& draft,
                      ResolvedSettings& result) {
  ErrorDetail detail = DetailOf(fault);
  const auto setting = detail.metadata.find("setting");
  if (detail.reason != Reason::kSettingMalformed || setting == detail.metadata.end()) return false;
  SharedText* const text = TemplateOf(setting->second, FdmOf(result.settings));
  if (text == nullptr || text->str().empty() || draft.At(setting->second).requested) return false;
  *text = SharedText();
  result.missing.push_back({std::string(kGcodeTemplates),
                            std::string(fault.message()) + "; the job can only leave it out",
                            std::move(detail.metadata)});
  return true;
}

}  // namespace slicefarm::config::fdm
