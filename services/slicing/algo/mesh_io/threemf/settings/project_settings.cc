#include "services/slicing/algo/mesh_io/threemf/settings/project_settings.h"

#include <nlohmann/json.hpp>

#include "common/base/text.h"
#include "common/base/utf8.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/settings/names.h"
#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

namespace slicefarm::slicing::threemf {
namespace {

using nlohmann::json;

absl::Status Add(std::string_view key, std::string_view value, ProjectSettings& project) {
  if (!NamesScripts(key)) return AddSetting(key, value, project.settings);
  project.has_scripts |= !value.empty() && value != "[]" && value != "\"\"" && value != "[\"\"]";
  return absl::OkStatus();
}

/// Returns a JSON value as text. Lists stay JSON; the slicers write only lists of texts.
std::string TextOf(const json& value) {
  return value.is_string() ? EscapedText(value.get_ref<const std::string&>()) : value.dump();
}

}  // namespace

absl::StatusOr<ProjectSettings> ReadPrusaSettings(std::string_view text, const std::string& part) {
  if (!IsUtf8(text)) return WithLocation({part, 1}, Malformed("the settings are not UTF-8 text"));
  ProjectSettings project;
  int64_t line = 0;
  for (std::string_view rest : Split(text, "\n")) {
    ++line;
    rest = Trim(rest);
    if (rest.starts_with(';')) rest.remove_prefix(1);
    const size_t equals = rest.find('=');
    if (equals == std::string_view::npos) continue;
    const std::string value = ReplaceControls(Trim(rest.substr(equals + 1)), ' ');
    absl::Status status = Add(Trim(rest.substr(0, equals)), value, project);
    if (!status.ok()) return WithLocation({part, line}, status);
  }
  return project;
}

absl::StatusOr<ProjectSettings> ReadOrcaSettings(std::string_view text, const std::string& part) {
  // A list within a list is no setting, and hostile files may nest a million of them.
  const auto is_flat = [](int depth, json::parse_event_t event, const json&) {
    const bool begins =
        event == json::parse_event_t::array_start || event == json::parse_event_t::object_start;
    return depth <= (begins ? 1 : 2);
  };
  const json all = json::parse(text.begin(), text.end(), is_flat, /*allow_exceptions=*/false);
  if (!all.is_object())
    return WithLocation({part, 1}, Malformed("the settings are not a JSON object"));
  ProjectSettings project;
  for (const auto& [key, value] : all.items()) {
    absl::Status status = Add(key, TextOf(value), project);
    if (!status.ok()) return WithLocation({part, 1}, status);
  }
  return project;
}

}  // namespace slicefarm::slicing::threemf
