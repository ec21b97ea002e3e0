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

/// Parsed values of long texts, such as fields, that several sets of settings share. Each long text
/// is parsed once.
class ParsedTexts {
 public:
  /// Returns ParseValue(spec, text). For a long text (limits::kLongTextBytes), stores the result or
  /// returns the stored result.
  absl::StatusOr<Value> Parse(const SettingSpec& spec, std::string_view text);

 private:
  std::map<std::pair<const SettingSpec*, std::string>, absl::StatusOr<Value>, std::less<>> known_;
};

/// Value of a profile that is out of its setting's range. It is an error only if the setting has an
/// effect: other programs write values of features that are off without checking them.
struct OutOfRange {
  const SettingSpec* spec = nullptr;
  std::string written;
  absl::Status error;
};

/// Reader that receives settings one by one. The last value of each key counts; the reader makes
/// notes on replaced values.
class SettingReader {
 public:
  /// Makes a reader. `tool`: index of the extruder; of a list with one item per extruder, the item
  /// of this extruder is used. `parsed` must outlive the reader.
  SettingReader(Process process, size_t tool, ParsedTexts& parsed);

  /// Reads a setting. Errors: any error of Resolve that concerns a single setting, except the
  /// errors in out_of_range().
  absl::Status Read(const Setting& setting);

  /// Notes a setting that is not read, because a later setting with the same key replaces it.
  void Skip(const Setting& setting) { NoteOverridden(setting, Trim(setting.value)); }

  /// Returns the values of profiles that are out of range, for settings that another setting may
  /// disable. These settings have their default values.
  const std::vector<OutOfRange>& out_of_range() const { return out_of_range_; }

  /// Returns the settings that no stage uses.
  ReportedSettings Reported() const;

  /// Returns the values; call it after all settings are read. Adds the settings without effect to
  /// `result`: changes of the print first, values of other extruders and modes last.
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
  std::vector<OutOfRange> out_of_range_;
  /// notes on values of other extruders and modes; Finish appends them to no_effect_
  std::vector<SettingNote> last_notes_;
  std::map<std::string, std::pair<std::string_view, std::string>> foreign_;
  std::map<std::string, std::pair<const KnownKey*, std::string>> others_;
  std::map<std::pair<Source, std::string>, std::string> last_;
};

}  // namespace slicefarm::config
