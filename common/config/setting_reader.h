#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "common/base/text.h"
#include "common/config/draft.h"
#include "common/config/resolve.h"
#include "common/config/table/known_keys.h"
#include "common/config/table/setting_spec.h"
#include "common/config/told_settings.h"

namespace slicefarm::config {

/// Values of long texts, such as fields, which sets of settings have in common: each is read once.
class ParsedTexts {
 public:
  /// ParseValue(spec, text).
  absl::StatusOr<Value> Parse(const SettingSpec& spec, std::string_view text);

 private:
  std::map<std::pair<const SettingSpec*, std::string>, absl::StatusOr<Value>, std::less<>> known_;
};

/// Reads settings one by one: the last value of each key, and what is to be said about the others.
class SettingReader {
 public:
  /// `tool`: whose items of lists count. `parsed` must outlive the reader.
  SettingReader(Process process, size_t tool, ParsedTexts& parsed);

  /// Errors: those of Resolve that are about one setting.
  absl::Status Read(const Setting& setting);

  /// Of a setting that a later one replaces, of whatever source.
  void Skip(const Setting& setting) { NoteOverridden(setting, Trim(setting.value)); }

  /// What was read and no stage works with.
  ToldSettings Told() const;

  /// The values, once all are read. Says in `result` what has no effect: what changes the print
  /// first, what describes profiles last.
  Draft Finish(ResolvedSettings& result);

 private:
  absl::Status ReadEffective(const SettingSpec& spec, Draft::Entry& entry, const Setting& setting,
                             std::string_view all);
  std::string Readable(const SettingSpec& spec, const std::string& value);

  void NoteOverridden(const Setting& setting, std::string_view value);
  void NoteEffective(const SettingSpec& spec, const Draft::Entry& entry);
  bool HasSilentMode() const;
  void NoteOtherItems(const SettingSpec& spec, const Draft::Entry& entry);
  void NoteMissingPercent(const SettingSpec& spec, std::string_view value);
  void NoteOther(const std::string& key, const KnownKey* known, const std::string& value);
  void Warn(std::string text);
  void SortNotes();

  const Process process_;
  const size_t tool_;
  ParsedTexts& parsed_;
  Draft draft_;
  std::vector<std::string> no_effect_;
  std::vector<std::string> warnings_;
  std::vector<MissingFeature> missing_;
  std::vector<std::string> last_notes_;  ///< those of no_effect_ that do not matter to the print
  std::map<std::string, std::pair<std::string_view, std::string>> foreign_;
  std::map<std::string, std::pair<const KnownKey*, std::string>> others_;
  std::map<std::pair<Source, std::string>, std::string> last_;
};

}  // namespace slicefarm::config
