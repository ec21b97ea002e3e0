#include "common/config/resolve.h"

#include <fmt/core.h>

#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/text.h"
#include "common/config/process_settings.h"
#include "common/config/setting_need.h"
#include "common/config/setting_reader.h"
#include "common/config/setting_values.h"
#include "common/config/table/need.h"
#include "common/config/table/setting_limits.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

absl::Status CheckLimits(std::span<const Setting> given) {
  absl::Status status = CheckSettingCount(std::ssize(given));
  for (const Setting& setting : given) {
    status.Update(CheckSettingSize(setting.key, setting.value));
  }
  return status;
}

/// Returns one flag per setting: true if a later setting with the same key replaces it. The value
/// of a replaced setting may be invalid. An empty value in a profile replaces nothing, because
/// profiles also contain empty texts for settings without a value.
std::vector<bool> Replaced(std::span<const Setting> given) {
  std::vector<bool> replaced(given.size());
  std::set<std::string_view> later;
  for (size_t i = given.size(); i-- > 0;) {
    replaced[i] = later.contains(given[i].key);
    const bool says = given[i].source == Source::kRequest || !Trim(given[i].value).empty();
    if (says) later.insert(given[i].key);
  }
  return replaced;
}

absl::Status ReadAll(std::span<const Setting> given, SettingReader& reader) {
  const std::vector<bool> replaced = Replaced(given);
  for (size_t i = 0; i < given.size(); ++i) {
    if (replaced[i]) {
      reader.Skip(given[i]);
    } else if (absl::Status status = reader.Read(given[i]); !status.ok()) {
      return status;
    }
  }
  return absl::OkStatus();
}

/// Adds notes on values that are out of range and have no effect. Errors: the error of the first
/// value that has an effect.
absl::Status JudgeOutOfRange(const std::vector<OutOfRange>& values, const SettingValues& draft,
                             ResolvedSettings& result) {
  for (const OutOfRange& value : values) {
    const Need* off = UnmetNeedOf(*value.spec, draft, result.settings);
    if (off == nullptr) return value.error;
    result.no_effect.push_back({.text = fmt::format("{} = {}: out of range, and needs {}",
                                                    value.spec->key, value.written, off->what),
                                .key = std::string(value.spec->key),
                                .why = SettingNote::Why::kUnmetNeed});
  }
  return absl::OkStatus();
}

/// Stores each value of `draft` in its member of `settings`.
void PutInto(JobRows& settings, const SettingValues& draft) {
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i)
    for (const Field& field : {table[i].field, table[i].also})
      if (field.set != nullptr) field.set(settings, *draft.entries()[i].value);
}

}  // namespace

absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process) {
  ParsedTexts parsed;
  return Resolve(given, process, parsed);
}

absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process,
                                         ParsedTexts& parsed) {
  if (absl::Status status = CheckLimits(given); !status.ok()) return status;
  ResolvedSettings result;
  const ProcessSettings& own = SettingsOf(process);
  result.settings = own.Standards();
  SettingReader reader(process, own.ListItem(given), parsed);
  if (absl::Status status = ReadAll(given, reader); !status.ok()) return status;
  ReportedSettings reported = reader.Reported();
  SettingValues draft = reader.Finish(result);
  ReportDerived(draft, reported);
  if (absl::Status status = own.Derive(draft, result); !status.ok()) return status;
  if (absl::Status status = own.Check(draft); !status.ok()) return status;
  PutInto(result.settings, draft);
  if (absl::Status status = own.DeriveOptions({draft, given, result, reported}); !status.ok())
    return status;
  if (absl::Status status = JudgeOutOfRange(reader.out_of_range(), draft, result); !status.ok())
    return status;
  for (SettingNote& note : UnmetNeeds(draft, result.settings))
    result.no_effect.push_back(std::move(note));
  result.effective_text = EffectiveText(result.settings, reported);
  if (absl::Status status = own.Finish(draft, result); !status.ok()) return status;
  return result;
}

namespace {

/// Returns true if an empty value of this setting is left out of the effective text. Few jobs have
/// fields, angles per layer, layer heights by z, excluded areas, or G-code at heights or of the
/// filament.
bool IsRare(const SettingSpec& spec) {
  return spec.kind == Kind::kDensityField || spec.kind == Kind::kStressField ||
         spec.kind == Kind::kMaterialField || spec.kind == Kind::kAngles ||
         spec.kind == Kind::kSolidLayers || spec.kind == Kind::kHeightCode ||
         spec.kind == Kind::kLayerHeights || spec.kind == Kind::kSubstitutions ||
         spec.kind == Kind::kAreas ||
         (spec.kind == Kind::kGcode && spec.list == List::kPerExtruder);
}

}  // namespace

std::string EffectiveText(const JobRows& settings, const ReportedSettings& reported) {
  ReportedSettings all = reported;
  for (const SettingSpec& spec : SettingsTable(settings.process())) {
    if (spec.field.get == nullptr) continue;
    const Value value = spec.field.get(settings);
    if (IsRare(spec) && value.text.str().empty()) continue;
    all[std::string(spec.key)] = PrintValue(spec, value);
  }
  std::string text;
  for (const auto& [key, value] : all) text += fmt::format("{} = {}\n", key, value);
  return text;
}

}  // namespace slicefarm::config
