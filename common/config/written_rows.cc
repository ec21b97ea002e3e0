#include "common/config/written_rows.h"

#include <array>
#include <set>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/config/table/settings_table.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

bool IsOfRegion(const Setting& setting, Process process) {
  const int index = FindSetting(setting.key, process);
  return index >= 0 && SettingsTable(process)[index].scope() >= Scope::kRegion;
}

/// Returns a digest of the settings in `settings` that concern regions; an empty text if there are
/// no such settings.
std::string NameOf(const std::vector<Setting>& settings, Process process) {
  Sha256 sha;
  bool any = false;
  for (const Setting& setting : settings) {
    if (!IsOfRegion(setting, process)) continue;
    any = true;
    for (const std::string_view text :
         {std::string_view(setting.key), std::string_view(setting.value)}) {
      sha.Add(text);
      sha.Add(std::string(1, '\0'));
    }
  }
  return any ? sha.Hex() : std::string();
}

}  // namespace

absl::Status CheckWrittenRows(std::span<const SceneObject> objects, Process process) {
  std::set<std::array<std::string, 3>> rows;
  for (const SceneObject& object : objects) {
    const std::string own = NameOf(object.settings, process);
    std::vector<std::string> ranges = {""};
    for (const HeightRange& range : object.ranges)
      ranges.push_back(NameOf(range.settings, process));
    for (const Part& part : object.parts) {
      if (part.role == PartRole::kModifier) continue;
      const std::string of_part = NameOf(part.settings, process);
      for (const std::string& range : ranges) rows.insert({own, of_part, range});
      if (std::ssize(rows) > limits::kMaxRegionSettings)
        return LimitError(Reason::kRequestTooLarge, "different sets of settings of regions",
                          limits::kMaxRegionSettings, std::ssize(rows));
    }
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::config
