#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "common/base/text.h"
#include "common/config/reported_settings.h"
#include "common/config/resolve.h"
#include "common/config/setting_values.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/setting_spec.h"

namespace slicefarm::config {

/// Parsed values of long texts, such as fields, that several sets of settings share. Each text is
/// parsed once.
class ParsedTexts {
 public:
  /// Returns ParseValue(spec, text).
  absl::StatusOr<Value> Parse(const SettingSpec& spec, std::string_view text);

 private:
  std::map<std::pair<const SettingSpec*, std::string>, absl::StatusOr<Value>, std::less<>> known_;
};

/// Reader that takes settings one by one. It keeps the last value of each key and makes notes on
/// replaced values.
class SettingReader {
 public:
  /// Makes a reader. `tool`: index of the item that counts in lists per extruder. `parsed` must
  /// outlive the reader.
  SettingReader(Process process, size_t tool, ParsedTexts& parsed);

  /// Reads a setting. Errors: any error of Resolve that concerns a single setting.
  absl::Status Read(const Setting& setting);

  /// Skips a setting that a later setting of any source replaces.
  void Skip(const Setting& setting) { NoteOverridden(setting, Trim(setting.value)); }

  /// Returns the settings that no stage uses.
  ReportedSettings Told() const;

  /// Returns the values after all settings are read. Reports the settings without effect in
  /// `result`: changes of the print first, descriptions of profiles last.
  SettingValues Finish(ResolvedSettings& result);

 private:
  absl::Status ReadEffective(const SettingSpec& spec, SettingValues::Entry& entry,
                             const Setting& setting, std::string_view all);
  std::string Readable(const SettingSpec& spec, const std::string& value);

  void NoteOverridden(const Setting& setting, std::string_view value);
  void NoteEffective(const SettingSpec& spec, const SettingValues::Entry& entry);
  bool HasSilentMode() const;
  void NoteOtherItems(const SettingSpec& spec, const SettingValues::Entry& entry);
  void NoteMissingPercent(const SettingSpec& spec, std::string_view value);
  void NoteOther(const std::string& key, const KnownKey* known, const std::string& value);
  void Warn(std::string text);
  void SortNotes();

  const Process process_;
  const size_t tool_;
  ParsedTexts& parsed_;
  SettingValues draft_;
  std::vector<SettingNote> no_effect_;
  std::vector<std::string> warnings_;
  std::vector<MissingFeature> missing_;
  /// notes that do not matter to the print; they follow no_effect_
  std::vector<SettingNote> last_notes_;
  std::map<std::string, std::pair<std::string_view, std::string>> foreign_;
  std::map<std::string, std::pair<const KnownKey*, std::string>> others_;
  std::map<std::pair<Source, std::string>, std::string> last_;
};

}  // namespace slicefarm::config
