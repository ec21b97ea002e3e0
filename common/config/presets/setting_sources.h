#pragma once

#include <string>
#include <vector>

#include "common/config/presets/preset.h"
#include "common/model/setting.h"
#include "common/model/setting_source.h"

namespace slicefarm::config::presets {

/// Setting in the names and values of a program, with its source as text for people.
struct LabelledSetting {
  Setting setting;
  std::string source;
};

/// Returns the text of a preset as a source: `process preset "0.20mm SPEED" (prusa@3/Prusa.ini)`.
std::string SourceText(const Preset& preset);

/// Returns the sources of settings under PrusaSlicer's names. A setting that is made from several
/// settings of OrcaSlicer has the source of the last one. Cost: one conversion for each source.
std::vector<SettingSource> SourcesOf(PresetDialect dialect,
                                     const std::vector<LabelledSetting>& settings);

/// Returns the sources with each key at the last source that has it. Equal sources are joined, and
/// sources without keys are left out. Keys are sorted.
std::vector<SettingSource> LastSources(const std::vector<SettingSource>& sources);

/// Returns one source with the keys of all settings.
SettingSource SourceOfAll(std::string source, const std::vector<Setting>& settings);

}  // namespace slicefarm::config::presets
