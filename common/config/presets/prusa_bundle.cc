#include "common/config/presets/prusa_bundle.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/projects/ini.h"
#include "common/config/projects/super_settings.h"
#include "common/config/table/setting_limits.h"
#include "common/macro/setting_types.h"

namespace slicefarm::config::presets {
namespace {

constexpr size_t kShown = 60;  // bytes of a line that an error shows

/// Section of an .ini file; the name is empty before the first section.
struct Section {
  std::string name;
  std::vector<Setting> settings;

  std::string_view Get(std::string_view key) const {
    const auto found = std::ranges::find(settings, key, &Setting::key);
    return found == settings.end() ? std::string_view() : found->value;
  }
};

absl::Status BadLine(int64_t line, std::string_view text, std::string_view why) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
      fmt::format("line {}: '{}' {}", line, ReplaceControls(text.substr(0, kShown), '?'), why),
      {{"line", std::to_string(line)}});
}

class SectionReader {
 public:
  absl::Status Take(int64_t number, std::string_view line) {
    line = Trim(line);
    if (line.empty() || line[0] == '#' || line[0] == ';') return absl::OkStatus();
    if (line[0] == '[') return Begin(number, line);
    const size_t equals = line.find('=');
    const std::string_view key = Trim(line.substr(0, equals));
    if (equals == std::string_view::npos || key.empty())
      return BadLine(number, line, "is not of the form key = value");
    if (!keys_.insert(std::string(key)).second)
      return BadLine(number, line, "sets a key that an earlier line of the section sets");
    Setting setting{std::string(key), std::string(Trim(line.substr(equals + 1))), Source::kProfile};
    absl::Status status = CheckSettingSize(setting.key, setting.value);
    sections_.back().settings.push_back(std::move(setting));
    status.Update(CheckSettingCount(std::ssize(sections_.back().settings)));
    return status;
  }

  std::vector<Section> Finish() && { return std::move(sections_); }

 private:
  absl::Status Begin(int64_t number, std::string_view line) {
    if (!line.ends_with(']')) return BadLine(number, line, "has no closing bracket");
    std::string name(Trim(line.substr(1, line.size() - 2)));
    if (!names_.insert(name).second)
      return BadLine(number, line, "begins a section that already exists");
    if (std::ssize(names_) > kMaxPresetFiles)
      return LimitError(Reason::kRequestTooLarge, "sections of the file", kMaxPresetFiles,
                        std::ssize(names_));
    sections_.push_back({std::move(name), {}});
    keys_.clear();
    return absl::OkStatus();
  }

  std::vector<Section> sections_ = {Section{}};
  std::set<std::string> names_, keys_;  ///< names of sections, and keys of the current section
};

absl::StatusOr<std::vector<Section>> ReadSections(std::string_view text) {
  SectionReader reader;
  int64_t number = 0;
  for (const std::string_view line : Split(text, "\n"))
    if (absl::Status status = reader.Take(++number, line); !status.ok()) return status;
  return std::move(reader).Finish();
}

/// Returns the kind and name in the name of a section, such as `print:NAME`.
std::optional<std::pair<PresetKind, std::string>> PresetNamed(std::string_view section) {
  constexpr std::pair<std::string_view, PresetKind> kKinds[] = {
      {"print:", PresetKind::kProcess},
      {"filament:", PresetKind::kFilament},
      {"printer:", PresetKind::kPrinter}};
  for (const auto& [prefix, kind] : kKinds)
    if (section.starts_with(prefix) && section.size() > prefix.size())
      return std::pair(kind, std::string(section.substr(prefix.size())));
  return std::nullopt;
}

/// Returns true if settings have names that only SuperSlicer has.
bool HasSuperKeys(const std::vector<Setting>& settings) {
  constexpr std::string_view kKeys[] = {"bridge_flow_ratio_internal",
                                        "default_speed",
                                        "external_perimeter_cut_corners",
                                        "infill_connection",
                                        "max_speed_reduction",
                                        "only_one_perimeter_top",
                                        "perimeter_loop",
                                        "thin_walls_merge",
                                        "external_infill_margin"};
  return std::ranges::any_of(settings, [&](const Setting& setting) {
    return std::ranges::find(kKeys, setting.key) != std::end(kKeys);
  });
}

PresetDialect DialectOfIni(std::string_view text, const std::vector<Section>& sections) {
  const bool super = IsSuperSlicers(text) || std::ranges::any_of(sections, [](const Section& each) {
                       return HasSuperKeys(each.settings);
                     });
  return super ? PresetDialect::kSuper : PresetDialect::kPrusa;
}

/// Returns the value of a setting with one value as a config.ini has it. Bundles also escape
/// quotes.
std::string PlainValue(const Setting& setting) {
  const auto type = macro::TypeOfSetting(setting.key);
  if ((type && type->is_list) || setting.value.find("\\\"") == std::string::npos)
    return setting.value;
  std::string plain;
  for (size_t i = 0; i < setting.value.size(); ++i) {
    const bool escape = setting.value[i] == '\\' && i + 1 < setting.value.size();
    if (escape && setting.value[i + 1] != '"') plain += setting.value[i];
    if (escape) ++i;
    plain += setting.value[i];
  }
  return plain;
}

/// Fills the members of a preset that are keys in the file, and keeps the remaining settings.
void TakeSettings(std::vector<Setting> settings, Preset& preset) {
  for (Setting& setting : settings) {
    if (setting.key == "inherits") {
      preset.parents = ListItems(setting.value);
    } else if (setting.key == "renamed_from") {
      preset.old_names = ListItems(setting.value);
    } else if (setting.key == "alias") {
      preset.alias = setting.value;
    } else {
      setting.value = PlainValue(setting);
      preset.settings.push_back(std::move(setting));
    }
  }
}

PrinterModel ModelOfSection(const Section& section, int32_t scope) {
  constexpr std::string_view kPrefix = "printer_model:";
  return {.id = section.name.substr(kPrefix.size()),
          .scope = scope,
          .name = std::string(section.Get("name")),
          .bed_type = "",
          .materials = ListItems(section.Get("default_materials"))};
}

/// Reader of one bundle: a file with sections.
class BundleReader {
 public:
  BundleReader(std::string file, PresetDialect dialect, PresetSet& set)
      : file_(std::move(file)), dialect_(dialect), set_(set) {}

  void Read(std::vector<Section> sections) {
    const auto vendor = std::ranges::find(sections, "vendor", &Section::name);
    vendor_ = vendor != sections.end();
    PresetScope scope;
    if (vendor_) {
      scope.vendor = std::string(vendor->Get("name"));
      if (scope.vendor.empty()) scope.vendor = file_;
      scope.templates = vendor->Get("templates_profile") == "1";
    }
    templates_ = scope.templates;
    scope_ = set_.AddScope(std::move(scope));
    for (Section& section : sections) {
      if (section.name.starts_with("printer_model:")) set_.Add(ModelOfSection(section, scope_));
      if (auto named = PresetNamed(section.name)) AddPreset(*std::move(named), std::move(section));
    }
  }

 private:
  void AddPreset(std::pair<PresetKind, std::string> named, Section section) {
    Preset preset;
    preset.kind = named.first;
    preset.name = std::move(named.second);
    preset.dialect = dialect_;
    preset.scope = scope_;
    preset.file = file_;
    TakeSettings(std::move(section.settings), preset);
    preset.listed = !preset.name.starts_with('*');
    // Bundles that users export have whole presets.
    preset.complete = !vendor_ && std::ranges::none_of(preset.parents, [](const auto& parent) {
      return parent.starts_with('*');
    });
    if (templates_ && preset.kind == PresetKind::kFilament) NameTemplate(preset);
    if (preset.alias.empty()) preset.alias = AliasOf(preset.name);
    set_.Add(std::move(preset));
  }

  /// Adds the ending of templates to the names of a filament and of its parents that are no bases.
  static void NameTemplate(Preset& preset) {
    constexpr std::string_view kEnding = " @Template";
    if (preset.listed) preset.name += kEnding;
    for (std::string& parent : preset.parents)
      if (!parent.starts_with('*')) parent += kEnding;
  }

  std::string file_;
  PresetDialect dialect_;
  PresetSet& set_;
  int32_t scope_ = 0;
  bool vendor_ = false;
  bool templates_ = false;
};

/// Returns the kind of a user's preset by the folder that it is in.
std::optional<PresetKind> KindOfFolder(std::string_view path) {
  const std::vector<std::string_view> folders = Split(path, "/");
  if (folders.size() < 2) return std::nullopt;
  const auto named = PresetNamed(std::string(folders[folders.size() - 2]) + ":x");
  return named ? std::optional(named->first) : std::nullopt;
}

/// Adds a file without sections. In a preset's folder, the file is one preset of this kind.
/// Otherwise it becomes one preset of each kind, with the names that the file contains.
void AddFlat(const PresetFile& file, PresetDialect dialect, std::vector<Setting> settings,
             PresetSet& set) {
  Preset preset;
  preset.dialect = dialect;
  preset.scope = set.AddScope({});
  preset.file = file.path;
  TakeSettings(std::move(settings), preset);
  preset.complete = true;
  preset.whole_job = !KindOfFolder(file.path);
  const auto add = [&](PresetKind kind, std::string_view id) {
    Preset one = preset;
    one.kind = kind;
    const auto named = std::ranges::find(one.settings, id, &Setting::key);
    if (named != one.settings.end()) {
      const std::vector<std::string> names = ListItems(named->value);
      one.name = names.empty() ? "" : names.front();
    }
    if (one.name.empty() || id.empty()) one.name = FileStem(file.path);
    one.alias = AliasOf(one.name);
    set.Add(std::move(one));
  };
  if (const auto kind = KindOfFolder(file.path)) return add(*kind, "");
  add(PresetKind::kPrinter, "printer_settings_id");
  add(PresetKind::kProcess, "print_settings_id");
  add(PresetKind::kFilament, "filament_settings_id");
}

}  // namespace

absl::Status AddIni(const PresetFile& file, PresetSet& set) {
  std::string_view text = file.bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find('\0') != std::string_view::npos) return BadLine(1, "", "is not text");
  auto sections = ReadSections(text);
  if (!sections.ok()) return sections.status();
  const PresetDialect dialect = DialectOfIni(text, *sections);
  if (sections->size() > 1) {
    BundleReader(file.path, dialect, set).Read(*std::move(sections));
  } else if (!sections->front().settings.empty()) {
    AddFlat(file, dialect, std::move(sections->front().settings), set);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::config::presets
