#include "processes/fdm/settings/filament_gcode.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "absl/strings/numbers.h"
#include "common/base/error.h"
#include "common/config/table/setting_limits.h"

namespace slicefarm::config::fdm {
namespace {

const std::string& Text(const Draft& draft, std::string_view key) {
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

}  // namespace

absl::Status JoinFilamentGcode(Draft& draft) {
  SharedText& end = draft.At("end_gcode").value->text;
  end = CodeOfBoth(Text(draft, "end_filament_gcode"), end.str());
  // The two together are one setting to the stages.
  return CheckSettingSize("end_gcode", end);
}

absl::Status NamingOwnGcode(const absl::Status& status, const Draft& draft) {
  const ErrorDetail detail = DetailOf(status);
  const auto setting = detail.metadata.find("setting"), at = detail.metadata.find("line");
  int32_t line = 0;
  if (status.ok() || setting == detail.metadata.end() || at == detail.metadata.end() ||
      !absl::SimpleAtoi(at->second, &line))
    return status;
  if (setting->second != "end_gcode") return status;
  const int32_t own = LinesOf(Text(draft, "end_filament_gcode"));
  if (line <= own) return Renamed(status, detail, "end_filament_gcode", line);
  return own == 0 ? status : Renamed(status, detail, "end_gcode", line - own);
}

}  // namespace slicefarm::config::fdm
