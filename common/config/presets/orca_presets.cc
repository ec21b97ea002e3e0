#include "common/config/presets/orca_presets.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/projects/orca_legacy.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

constexpr std::string_view kLists[] = {"machine_model_list", "machine_list", "process_list",
                                       "filament_list"};

/// Members that describe a preset and are no settings.
constexpr std::string_view kNoSettings[] = {
    "base_id",       "description",       "from", "include",      "inherits",
    "instantiation", "is_custom_defined", "name", "renamed_from", "setting_id",
    "type",          "updated_time",      "url",  "user_id",      "version"};

bool IsOneOf(std::string_view key, std::span<const std::string_view> keys) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Look-up of an object's members. If a key is repeated, its last value counts.
class Members {
 public:
  explicit Members(const FlatJson& json) {
    for (const Setting& member : json.members) by_key_[member.key] = &member;
  }

  bool Has(std::string_view key) const { return by_key_.contains(key); }
  std::string_view Raw(std::string_view key) const {
    const auto found = by_key_.find(key);
    return found == by_key_.end() ? std::string_view() : found->second->value;
  }
  /// Returns a text, or the first item of a list.
  std::string Text(std::string_view key) const {
    const std::string_view raw = Raw(key);
    if (!raw.starts_with('[')) return Unescape(raw);
    const std::vector<std::string> items = ListItems(raw);
    return items.empty() ? "" : items.front();
  }

 private:
  std::map<std::string_view, const Setting*> by_key_;
};

std::optional<PresetKind> KindNamed(std::string_view name) {
  if (name == "machine" || name == "printer") return PresetKind::kPrinter;
  if (name == "process" || name == "print") return PresetKind::kProcess;
  if (name == "filament") return PresetKind::kFilament;
  return std::nullopt;
}

/// Returns the kind of a preset from the first of these: the file's `type`, a key that only one
/// kind has, the name of the innermost folder that names a kind.
std::optional<PresetKind> KindOf(const std::string& path, const Members& members) {
  if (members.Has("type")) return KindNamed(members.Text("type"));
  if (members.Has("printer_settings_id")) return PresetKind::kPrinter;
  if (members.Has("print_settings_id")) return PresetKind::kProcess;
  if (members.Has("filament_settings_id")) return PresetKind::kFilament;
  const std::vector<std::string_view> folders = Split(path, "/");
  for (auto folder = folders.rbegin() + (folders.empty() ? 0 : 1); folder < folders.rend();
       ++folder)
    if (const auto kind = KindNamed(*folder)) return kind;
  return std::nullopt;
}

/// Returns the name of a preset from the first of these: the file's `name`, the id setting of the
/// preset's kind (such as `print_settings_id`), the file's name.
std::string NameOf(const std::string& path, PresetKind kind, const Members& members) {
  const std::string_view id = kind == PresetKind::kPrinter   ? "printer_settings_id"
                              : kind == PresetKind::kProcess ? "print_settings_id"
                                                             : "filament_settings_id";
  for (const std::string_view key : {std::string_view("name"), id})
    if (std::string name = members.Text(key); !name.empty()) return name;
  return FileStem(path);
}

PrinterModel ModelOfFile(const Members& members) {
  PrinterModel model;
  model.id = members.Text("name");
  model.name = model.id;
  model.bed_type = members.Text("default_bed_type");
  model.materials = ListItems(members.Text("default_materials"));
  return model;
}

}  // namespace

bool IsVendorList(const FlatJson& json) {
  const bool filled = std::ranges::any_of(
      json.ignored, [](const std::string& key) { return IsOneOf(key, kLists); });
  return filled || std::ranges::any_of(json.members, [](const Setting& member) {
           return IsOneOf(member.key, kLists) && member.value == "[]";
         });
}

absl::StatusOr<std::vector<std::string>> PathsOfVendorList(std::string_view text) {
  const auto json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  std::vector<std::string> paths;
  for (const std::string_view list : kLists) {
    const auto found = json.find(list);
    if (found == json.end() || !found->is_array()) continue;
    for (const auto& item : *found) {
      const auto path = item.is_object() ? item.find("sub_path") : item.end();
      if (!item.is_object() || path == item.end() || !path->is_string())
        return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                         "an item of " + std::string(list) + " has no text sub_path");
      paths.push_back(path->get<std::string>());
    }
  }
  return paths;
}

OrcaFile ReadOrcaFile(const std::string& path, FlatJson json, bool of_vendor) {
  const Members members(json);
  OrcaFile file;
  if (members.Text("type") == "machine_model") {
    file.is = OrcaFile::Is::kModel;
    file.model = ModelOfFile(members);
    return file;
  }
  const std::optional<PresetKind> kind = KindOf(path, members);
  if (!kind) return file;
  file.is = OrcaFile::Is::kPreset;
  Preset& preset = file.preset;
  preset.kind = *kind;
  preset.file = path;
  preset.name = NameOf(path, *kind, members);
  preset.alias = members.Has("alias") ? members.Text("alias") : AliasOf(preset.name);
  preset.listed = members.Text("instantiation") != "false";
  preset.old_names = ListItems(members.Text("renamed_from"));
  if (std::string parent = members.Text("inherits"); !parent.empty())
    preset.parents.push_back(std::move(parent));
  // Bambu Studio applies included presets over the parent, in vendors' files only.
  if (of_vendor)
    std::ranges::move(ListItems(members.Raw("include")), std::back_inserter(preset.parents));
  preset.complete = members.Text("is_custom_defined") == "1";
  for (Setting& member : json.members) {
    if (IsOneOf(member.key, kNoSettings)) continue;
    Setting setting = Modernized(member);
    const bool replaced = setting.key != member.key && members.Has(setting.key);
    if (!replaced) preset.settings.push_back(std::move(setting));
  }
  return file;
}

}  // namespace slicefarm::config::presets
