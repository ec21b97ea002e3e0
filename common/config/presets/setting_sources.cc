#include "common/config/presets/setting_sources.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

#include "common/base/text.h"
#include "common/config/projects/orca_settings.h"
#include "common/config/projects/super_settings.h"

namespace slicefarm::config::presets {
namespace {

std::vector<Setting> InNamesOfPrusa(PresetDialect dialect, std::vector<Setting> settings) {
  if (dialect == PresetDialect::kOrca) return FromOrca(settings, nullptr);
  if (dialect == PresetDialect::kSuper) return FromSuperSlicer(std::move(settings));
  return settings;
}

}  // namespace

std::string SourceText(const Preset& preset) {
  return fmt::format("{} preset \"{}\" ({})", KindName(preset.kind),
                     ReplaceControls(preset.name, '?'), ReplaceControls(preset.file, '?'));
}

std::vector<SettingSource> SourcesOf(PresetDialect dialect,
                                     const std::vector<LabelledSetting>& settings) {
  std::vector<std::string> labels;
  for (const LabelledSetting& each : settings)
    if (std::ranges::find(labels, each.source) == labels.end()) labels.push_back(each.source);
  std::vector<SettingSource> sources;
  for (const std::string& label : labels) {
    // The conversion keeps the source of each setting, which so marks the settings of this label.
    std::vector<Setting> marked;
    for (const LabelledSetting& each : settings) {
      marked.push_back(each.setting);
      marked.back().source = each.source == label ? Source::kRequest : Source::kProfile;
    }
    SettingSource source = {label, {}};
    for (Setting& made : InNamesOfPrusa(dialect, std::move(marked)))
      if (made.source == Source::kRequest) source.keys.push_back(std::move(made.key));
    sources.push_back(std::move(source));
  }
  return sources;
}

std::vector<SettingSource> LastSources(const std::vector<SettingSource>& sources) {
  std::map<std::string, std::string> source_of;  // by key
  std::vector<SettingSource> last;
  for (const SettingSource& each : sources) {
    if (std::ranges::find(last, each.source, &SettingSource::source) == last.end())
      last.push_back({each.source, {}});
    for (const std::string& key : each.keys) source_of[key] = each.source;
  }
  for (auto& [key, source] : source_of)
    std::ranges::find(last, source, &SettingSource::source)->keys.push_back(key);
  std::erase_if(last, [](const SettingSource& each) { return each.keys.empty(); });
  return last;
}

SettingSource SourceOfAll(std::string source, const std::vector<Setting>& settings) {
  SettingSource all = {std::move(source), {}};
  for (const Setting& setting : settings) all.keys.push_back(setting.key);
  return all;
}

}  // namespace slicefarm::config::presets
