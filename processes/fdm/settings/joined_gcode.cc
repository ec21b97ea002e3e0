#include "processes/fdm/settings/joined_gcode.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "absl/strings/numbers.h"
#include "common/base/error.h"
#include "common/config/table/setting_limits.h"
#include "common/model/options/machine_limits.h"

namespace slicefarm::config::fdm {
namespace {

const std::string& Text(const SettingValues& draft, std::string_view key) {
  return draft.At(key).value->text.str();
}

std::string CodeOfBoth(const std::string& first, const std::string& second) {
  const bool needs_break = !first.empty() && !second.empty() && first.back() != '\n';
  return first + (needs_break ? "\n" : "") + second;
}

int32_t LinesOf(const std::string& text) {
  const bool open_end = !text.empty() && text.back() != '\n';
  return static_cast<int32_t>(std::ranges::count(text, '\n')) + (open_end ? 1 : 0);
}

absl::Status Renamed(const absl::Status& status, ErrorDetail detail, std::string_view setting,
                     int32_t line) {
  const std::string_view message(status.message().data(), status.message().size());
  const std::string said =
      fmt::format("{}, line {}", detail.metadata["setting"], detail.metadata["line"]);
  detail.metadata["setting"] = setting;
  detail.metadata["line"] = std::to_string(line);
  const std::string_view rest = message.substr(message.starts_with(said) ? said.size() : 0);
  return MakeError(status.code(), detail.reason, fmt::format("{}, line {}{}", setting, line, rest),
                   detail.metadata);
}

/// Two settings that stages use as one.
struct Joint {
  std::string_view into;   ///< the setting that contains both texts
  std::string_view other;  ///< the setting that is joined to it
  bool other_first = true;
};

std::array<Joint, 5> JointsOf(const SettingValues& draft) {
  const bool bambu = draft.Number("gcode_flavor") == static_cast<double>(GcodeFlavor::kBambu);
  return {Joint{"end_gcode", "end_filament_gcode"},
          Joint{"layer_gcode", "time_lapse_gcode", !bambu},
          Joint{"layer_gcode", "wrapping_detection_gcode"},
          Joint{"change_extrusion_role_gcode", "filament_change_extrusion_role_gcode", false},
          Joint{"change_extrusion_role_gcode", "process_change_extrusion_role_gcode", false}};
}

/// Limits wrapping_detection_gcode to its layers. The lines of the text keep their numbers.
void LimitWrappingDetection(SettingValues& draft) {
  SharedText& code = draft.At("wrapping_detection_gcode").value->text;
  if (code.empty()) return;
  const auto layers = static_cast<int32_t>(draft.Number("wrapping_detection_layers"));
  code = fmt::format("{{if layer_num > 0 && layer_num <= {}}}{}\n{{endif}}", layers, code.str());
}

}  // namespace

absl::Status JoinGcode(SettingValues& draft) {
  LimitWrappingDetection(draft);
  for (const Joint& joint : JointsOf(draft)) {
    SharedText& into = draft.At(joint.into).value->text;
    const std::string& other = Text(draft, joint.other);
    if (other.empty()) continue;
    into = joint.other_first ? CodeOfBoth(other, into.str()) : CodeOfBoth(into.str(), other);
    if (absl::Status ok = CheckSettingSize(joint.into, into); !ok.ok()) return ok;
  }
  return absl::OkStatus();
}

absl::Status NamingOwnGcode(const absl::Status& status, const SettingValues& draft) {
  const ErrorDetail detail = DetailOf(status);
  const auto setting = detail.metadata.find("setting"), at = detail.metadata.find("line");
  int32_t line = 0;
  if (status.ok() || setting == detail.metadata.end() || at == detail.metadata.end() ||
      !absl::SimpleAtoi(at->second, &line))
    return status;
  const auto joints = JointsOf(draft);
  int32_t total = -1;  // lines of the text without the joints that the loop has passed
  for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
    const int32_t others = LinesOf(Text(draft, joint->other));
    if (setting->second != joint->into || others == 0) continue;
    if (total < 0) total = LinesOf(Text(draft, joint->into));
    const int32_t first = joint->other_first ? others : total - others;
    const bool in_first = line <= first;
    if (in_first == joint->other_first)
      return Renamed(status, detail, joint->other, in_first ? line : line - first);
    if (joint->other_first) line -= others;
    total -= others;
  }
  return total < 0 ? status : Renamed(status, detail, setting->second, line);
}

}  // namespace slicefarm::config::fdm
