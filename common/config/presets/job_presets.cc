#include "common/config/presets/job_presets.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "common/config/presets/preset_keys.h"
#include "common/config/projects/orca_settings.h"
#include "common/config/projects/super_settings.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

using ByKey = std::map<std::string, SourcedValue, std::less<>>;

/// Returns true for settings that describe which presets fit together. They are meaningless in a
/// combination of presets.
bool DescribesPreset(std::string_view key) {
  return key.starts_with("compatible_print") || key == "inherits";
}

void AddDefaults(PresetKind kind, ByKey& values) {
  for (const auto& [key, value] : OrcaDefaultsOf(kind))
    values[std::string(key)] = {std::string(key), std::string(value), nullptr};
}

absl::Status AddPreset(const PresetSet& set, const Preset& preset, ByKey& values) {
  const auto flat = set.Flatten(preset);
  if (!flat.ok()) return flat.status();
  // SuperSlicer has settings in presets of other kinds than PrusaSlicer.
  const bool any_key = preset.dialect == PresetDialect::kSuper && !preset.whole_job;
  for (const auto& [key, value] : *flat)
    if (!DescribesPreset(key) && (any_key || MayHaveKey(preset.kind, preset.dialect, key)))
      values[key] = {key, value.value, value.from};
  return absl::OkStatus();
}

/// Adds `curr_bed_type`, the plate on the printer's bed, if the printer or its model names a
/// default. The printer's default is a number or a name.
void AddBedType(const PresetSet& set, const Preset& printer, ByKey& values) {
  static const auto* const kNumbered = new std::map<std::string_view, std::string_view>{
      {"1", "Cool Plate"},         {"2", "Engineering Plate"},   {"3", "High Temp Plate"},
      {"4", "Textured PEI Plate"}, {"5", "Textured Cool Plate"}, {"6", "Supertack Plate"}};
  if (values.contains("curr_bed_type")) return;
  std::string type;
  if (const auto own = values.find("default_bed_type"); own != values.end())
    type = Unescape(own->second.value);
  const PrinterModel* model = set.ModelOf(printer);
  if (type.empty() && model != nullptr) type = model->bed_type;
  if (const auto name = kNumbered->find(type); name != kNumbered->end()) type = name->second;
  if (!type.empty()) values["curr_bed_type"] = {"curr_bed_type", Escape(type), &printer};
}

void AddNames(const ChosenPresets& chosen, ByKey& values) {
  const bool orca = chosen.printer->dialect == PresetDialect::kOrca;
  const auto add = [&](std::string key, const Preset* preset) {
    values[key] = {key, Escape(preset->name), preset};
  };
  add("printer_settings_id", chosen.printer);
  add("print_settings_id", chosen.process);
  add("filament_settings_id", chosen.filament);
  if (!orca) values["filament_settings_id"].value = QuoteText(chosen.filament->name);
}

std::vector<Setting> AsSettings(const std::vector<SourcedValue>& values) {
  std::vector<Setting> settings;
  for (const SourcedValue& each : values)
    settings.push_back({each.key, each.value, Source::kProfile});
  return settings;
}

/// Converts OrcaSlicer's settings. A default without effect is reported only if it changes the
/// print.
JobPresets FromOrcaPresets(const std::vector<SourcedValue>& values) {
  OrcaUnused unused;
  JobPresets job;
  job.settings = FromOrca(AsSettings(values), &unused);
  job.of_print = std::move(unused.of_print);
  std::set<std::string_view> given;
  for (const SourcedValue& each : values)
    if (each.from != nullptr) given.insert(each.key);
  for (std::string& line : unused.others)
    if (given.contains(KeyOfUnused(line))) job.others.push_back(std::move(line));
  return job;
}

}  // namespace

absl::StatusOr<std::vector<SourcedValue>> CombinePresets(const PresetSet& set,
                                                         const ChosenPresets& chosen) {
  const Preset* const presets[] = {chosen.process, chosen.printer, chosen.filament};
  const bool orca = chosen.printer->dialect == PresetDialect::kOrca;
  ByKey values;
  for (const Preset* preset : presets)
    if (orca) AddDefaults(preset->kind, values);
  for (const Preset* preset : presets)
    if (absl::Status status = AddPreset(set, *preset, values); !status.ok()) return status;
  if (orca) AddBedType(set, *chosen.printer, values);
  AddNames(chosen, values);
  std::vector<SourcedValue> all;
  for (auto& [key, value] : values) all.push_back(std::move(value));
  return all;
}

std::vector<LabelledSetting> Labelled(const std::vector<SourcedValue>& values) {
  std::vector<LabelledSetting> labelled;
  for (const SourcedValue& each : values)
    labelled.push_back(
        {{each.key, each.value, Source::kProfile},
         each.from == nullptr ? "default of the presets' program" : SourceText(*each.from)});
  return labelled;
}

absl::StatusOr<JobPresets> SettingsOfPresets(const PresetSet& set, const ChosenPresets& chosen) {
  auto values = CombinePresets(set, chosen);
  if (!values.ok()) return values.status();
  const Preset* const presets[] = {chosen.printer, chosen.process, chosen.filament};
  const bool super = std::ranges::any_of(
      presets, [](const Preset* preset) { return preset->dialect == PresetDialect::kSuper; });
  const PresetDialect dialect = super ? PresetDialect::kSuper : chosen.printer->dialect;
  JobPresets job;
  if (dialect == PresetDialect::kOrca) {
    job = FromOrcaPresets(*values);
  } else {
    job.settings = AsSettings(*values);
    if (super) job.settings = FromSuperSlicer(std::move(job.settings));
  }
  job.sources = SourcesOf(dialect, Labelled(*values));
  return job;
}

}  // namespace slicefarm::config::presets
