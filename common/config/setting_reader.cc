#include "common/config/setting_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/process_settings.h"
#include "common/config/table/orca_table.h"
#include "common/config/table/settings_table.h"
#include "common/config/table/suggest.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

/// Returns a value in short form for a report, because start G-codes and ramming tables are long.
std::string Quoted(std::string_view key, std::string_view value) {
  constexpr size_t kMax = 40;
  return fmt::format("{} = {}{}", key, value.substr(0, kMax), value.size() > kMax ? "..." : "");
}

/// Returns the item of extruder `tool` if the setting has one item per extruder; otherwise the
/// unchanged value.
std::string ItemOf(const SettingSpec& spec, std::string_view value, size_t tool) {
  if (spec.list != List::kPerExtruder) return std::string(value);
  if (spec.kind == Kind::kText || spec.kind == Kind::kGcode)
    return QuoteText(TextOfList(value, tool));
  const std::vector<std::string_view> items = Split(value, ",;");
  return std::string(Trim(items[tool < items.size() ? tool : 0]));
}

/// Returns the name of another process that has the setting; an empty text if no other process has
/// it.
std::string_view OwnerOf(std::string_view key, Process process) {
  for (const ProcessInfo& info : kProcesses)
    if (info.process != process && FindSetting(key, info.process) >= 0) return info.name;
  for (const ProcessInfo& info : kProcesses)
    if (info.process != process && SettingsOf(info.process).Knows(key)) return info.name;
  return {};
}

absl::Status OfOtherProcess(const std::string& key, std::string_view owner, Process process) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOfOtherProcess,
                   fmt::format("{} is a setting of process {}, and the job is of process {}", key,
                               owner, ProcessName(process)),
                   {{"setting", key}, {"process", std::string(owner)}});
}

/// Returns the error for a requested setting that would change the print and is not supported. A
/// person who requests it must not get a different print.
absl::Status NotMade(const std::string& key, std::string_view value, const KnownKey& known) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNotSupported,
                   fmt::format("{}: {}", Quoted(key, value), known.why),
                   {{"feature", key}, {"setting", key}, {"value", std::string(value)}});
}

/// Returns the setting that OrcaSlicer and Bambu Studio call `key`, or an empty text.
std::string FromOrcaName(std::string_view key, Process process) {
  const auto rows = OrcaRows();
  const auto row = std::ranges::find(rows, key, &OrcaRow::from);
  const bool known = row != rows.end() && FindSetting(row->to, process) >= 0;
  return known ? std::string(row->to) : "";
}

absl::Status UnknownSetting(const std::string& key, Process process) {
  std::string nearest = FromOrcaName(key, process);
  if (nearest.empty()) nearest = NearestSetting(key, process);
  std::map<std::string, std::string> metadata = {{"setting", key}};
  if (!nearest.empty()) metadata["suggestion"] = nearest;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingUnknown,
                   fmt::format("there is no setting '{}'{}", key,
                               nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest)),
                   std::move(metadata));
}

std::string_view FirstItem(std::string_view value) {
  return Trim(value.substr(0, value.find(',')));
}

bool IsNumber(const SettingSpec& spec) {
  return spec.kind == Kind::kInteger || spec.kind == Kind::kNumber || spec.kind == Kind::kPercent ||
         spec.kind == Kind::kNumberOrPercent;
}

std::string_view NumberAtFront(std::string_view value) {
  size_t end = value.size();
  while (end > 0 && !ToNumber(value.substr(0, end)).has_value()) --end;
  return Trim(value.substr(0, end));
}

/// Completes a list of corners: a corner without "x" gets 0 as its second number.
std::string WithAllCorners(std::string_view value) {
  std::string corners;
  for (const std::string_view corner : Split(value, ",")) {
    const bool whole = corner.find('x') != std::string_view::npos;
    corners += fmt::format("{}{}{}", corners.empty() ? "" : ",",
                           whole ? corner : NumberAtFront(corner), whole ? "" : "x0");
  }
  return corners;
}

/// Returns the choice named `value` if the choice has a substitute, otherwise null.
const Choice* StandIn(const SettingSpec& spec, std::string_view value) {
  for (const Choice& choice : spec.choices) {
    if (choice.name == value && !choice.note.empty()) return &choice;
  }
  return nullptr;
}

/// Returns true if the error of a value may not matter, because another setting disables its
/// setting.
bool MayBeOff(const SettingSpec& spec, const Setting& setting, const absl::Status& error) {
  return setting.source == Source::kProfile && !spec.needs.empty() &&
         DetailOf(error).reason == Reason::kSettingOutOfRange;
}

absl::Status RefuseStandIn(const SettingSpec& spec, std::string_view value) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNotSupported,
                   fmt::format("{} = {} is not supported yet: the value must be {}", spec.key,
                               value, DescribeRange(spec)),
                   {{"feature", fmt::format("{}={}", spec.key, value)},
                    {"setting", std::string(spec.key)},
                    {"value", std::string(value)}});
}

}  // namespace

absl::StatusOr<Value> ParsedTexts::Parse(const SettingSpec& spec, std::string_view text) {
  if (std::ssize(text) < limits::kLongTextBytes) return ParseValue(spec, text);
  const auto [known, added] =
      known_.try_emplace({&spec, std::string(text)}, absl::UnknownError("not read yet"));
  if (added) known->second = ParseValue(spec, text);
  return known->second;
}

SettingReader::SettingReader(Process process, size_t tool, ParsedTexts& parsed)
    : process_(process), tool_(tool), parsed_(parsed), draft_(process) {}

absl::Status SettingReader::Read(const Setting& setting) {
  const std::string_view value = Trim(setting.value);
  NoteOverridden(setting, value);
  if (const int index = FindSetting(setting.key, process_); index >= 0) {
    return ReadEffective(SettingsTable(process_)[index], draft_.entries()[index], setting, value);
  }
  if (const std::string_view owner = OwnerOf(setting.key, process_); !owner.empty()) {
    if (setting.source == Source::kRequest) return OfOtherProcess(setting.key, owner, process_);
    foreign_[setting.key] = {owner, std::string(value)};
    return absl::OkStatus();
  }
  if (const KnownKey* known = FindKnownKey(setting.key)) {
    const bool asks = setting.source == Source::kRequest && known->changes_print;
    if (asks && !IsNeutral(*known, value)) return NotMade(setting.key, value, *known);
    others_[setting.key] = {known, std::string(value)};
    return absl::OkStatus();
  }
  if (setting.source == Source::kRequest) return UnknownSetting(setting.key, process_);
  others_[setting.key] = {nullptr, std::string(value)};
  return absl::OkStatus();
}

/// Reports the settings without effect, after all settings are read.
SettingValues SettingReader::Finish(ResolvedSettings& result) {
  const auto table = SettingsTable(process_);
  for (size_t i = 0; i < table.size(); ++i) {
    if (draft_.entries()[i].given) NoteEffective(table[i], draft_.entries()[i]);
  }
  for (const auto& [key, other] : others_) NoteOther(key, other.first, other.second);
  for (const auto& [key, other] : foreign_)
    no_effect_.push_back(
        {fmt::format("{}: a setting of process {}", Quoted(key, other.second), other.first)});
  result.beside_print = std::ssize(last_notes_);
  SortNotes();
  result.no_effect = std::move(no_effect_);
  result.warnings = std::move(warnings_);
  result.missing = std::move(missing_);
  return std::move(draft_);
}

/// Returns the settings that no stage uses.
ReportedSettings SettingReader::Reported() const {
  ReportedSettings reported;
  for (const auto& [key, other] : others_) Report(key, other.second, reported);
  return reported;
}

absl::Status SettingReader::ReadEffective(const SettingSpec& spec, SettingValues::Entry& entry,
                                          const Setting& setting, std::string_view all) {
  const std::string item = ItemOf(spec, all, tool_);
  const std::string value = setting.source == Source::kRequest ? item : Readable(spec, item);
  if (value.empty() && setting.source != Source::kRequest && IsNumber(spec)) {
    Warn(fmt::format("{} has no value: the default {} is used", spec.key, spec.standard));
    return absl::OkStatus();
  }
  const bool is_not_set = spec.standard == kNotSet && FirstItem(value) == kNotSet;
  absl::StatusOr<Value> parsed = is_not_set ? Value() : parsed_.Parse(spec, value);
  if (MayBeOff(spec, setting, parsed.status())) {
    out_of_range_.push_back({&spec, value, parsed.status()});
    return absl::OkStatus();
  }
  entry.all = std::string(all);
  entry.written = value;
  entry.given = true;
  entry.requested = setting.source == Source::kRequest;
  if (is_not_set) {
    entry.value.reset();
    return absl::OkStatus();
  }
  if (!parsed.ok()) return parsed.status();
  if (setting.source == Source::kRequest) {
    if (const Choice* choice = StandIn(spec, value)) return RefuseStandIn(spec, choice->name);
  }
  entry.value = *std::move(parsed);
  return absl::OkStatus();
}

/// Removes text after a number that vendors' files contain, such as a comment or a percent sign
/// without a base. PrusaSlicer ignores such text, too.
std::string SettingReader::Readable(const SettingSpec& spec, const std::string& value) {
  const bool has_corners =
      spec.kind == Kind::kBedShape || spec.kind == Kind::kAreas || spec.kind == Kind::kPoint;
  if (!(has_corners || IsNumber(spec)) || ParseValue(spec, value).ok()) return value;
  std::string read = has_corners ? WithAllCorners(value) : std::string(NumberAtFront(value));
  if (read.empty() || read == value) return value;
  Warn(fmt::format("{}: only {} is used", Quoted(spec.key, value), read));
  return read;
}

/// Notes a setting that replaces another value of the same key from the same source, which is
/// probably a mistake. A request that overrides a profile is not noted.
void SettingReader::NoteOverridden(const Setting& setting, std::string_view value) {
  const auto [entry, first] = last_.try_emplace({setting.source, setting.key}, value);
  std::string& last = entry->second;
  if (first || last == value) return;
  no_effect_.push_back(
      {.text = fmt::format("{}: overridden by a later {}", Quoted(setting.key, last), setting.key),
       .key = setting.key,
       .why = SettingNote::Why::kOverridden});
  last = std::string(value);
}

void SettingReader::Warn(std::string text) {
  no_effect_.push_back({text});
  warnings_.push_back(std::move(text));
}

void SettingReader::NoteEffective(const SettingSpec& spec, const SettingValues::Entry& entry) {
  const std::string_view value = entry.written;
  if (const Choice* choice = StandIn(spec, value)) {
    Warn(fmt::format("{}: {}", Quoted(spec.key, value), choice->note));
  }
  NoteOtherItems(spec, entry);
  if (spec.kind == Kind::kPercent && !value.ends_with("%")) NoteMissingPercent(spec, value);
}

/// Returns true if the second values of the machine's limits are used.
bool SettingReader::HasSilentMode() const {
  constexpr std::string_view kKey = "silent_mode";
  return FindSetting(kKey, draft_.process()) >= 0 && draft_.Number(kKey) != 0;
}

/// Notes the items of a list that have no effect. Only one item has an effect: the item of the
/// tool, or of the machine's normal mode.
void SettingReader::NoteOtherItems(const SettingSpec& spec, const SettingValues::Entry& entry) {
  const std::string_view separator =
      spec.kind == Kind::kText || spec.kind == Kind::kGcode ? ";" : ",";
  const std::string_view all = entry.all;
  if (spec.list == List::kNone || all.find('"') != std::string_view::npos) return;
  const std::vector<std::string_view> items = Split(all, separator);
  if (std::ranges::all_of(items,
                          [&](std::string_view item) { return Trim(item) == Trim(items[0]); }))
    return;
  if (spec.list == List::kPerMode && HasSilentMode()) return;
  const std::string text = fmt::format("{}: only {}, {}, has an effect", Quoted(spec.key, all),
                                       tool_ == 0 || spec.list != List::kPerExtruder
                                           ? "the first value"
                                           : fmt::format("the value of extruder {}", tool_ + 1),
                                       entry.written);
  // A profile has values for all extruders, and the printing extruder is known. No machine of
  // slicefarm uses the silent mode.
  if (spec.list == List::kPerExtruder && entry.requested) {
    Warn(text);
  } else {
    last_notes_.push_back({text});
  }
}

void SettingReader::NoteMissingPercent(const SettingSpec& spec, std::string_view value) {
  const auto number = ParseNumber(value, false);
  if (!number.ok() || number->number <= 0 || number->number >= 1) return;
  warnings_.push_back(fmt::format("{0} = {1} means {1}%; if you mean {2}%, write the percent sign",
                                  spec.key, value, PrintNumber(number->number * 100)));
}

void SettingReader::NoteOther(const std::string& key, const KnownKey* known,
                              const std::string& value) {
  if (known == nullptr) {
    no_effect_.push_back({Quoted(key, value) + ": unknown"});
    return;
  }
  if (IsNeutral(*known, value)) return;
  const std::string text = fmt::format("{}: {}", Quoted(key, value), known->why);
  if (known->changes_print) {
    Warn(text);
    if (known->spoils_print) missing_.push_back({key, text, {{"setting", key}, {"value", value}}});
  } else {
    // A profile describes itself, its host and several extruders; these settings change no print.
    const bool matters = known->of_print && !known->of_several_extruders;
    if (matters) no_effect_.push_back({text});
  }
}

/// Sorts the notes: changes of the print first, values of other extruders and modes last.
void SettingReader::SortNotes() {
  std::vector<SettingNote>& notes = no_effect_;
  const std::set<std::string> weighty(warnings_.begin(), warnings_.end());
  std::stable_partition(notes.begin(), notes.end(),
                        [&](const SettingNote& note) { return weighty.contains(note.text); });
  std::ranges::move(last_notes_, std::back_inserter(notes));
}

}  // namespace slicefarm::config
