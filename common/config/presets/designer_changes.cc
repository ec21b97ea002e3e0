#include "common/config/presets/designer_changes.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/base/text.h"
#include "common/config/presets/portable_settings.h"
#include "common/config/presets/preset_keys.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

using Texts = std::vector<std::string>;

/// Returns the items of a list in the form of a project, with empty ones: JSON of OrcaSlicer, or
/// `"a";;"b"`.
Texts AllItems(std::string_view text) {
  Texts items;
  if (text.starts_with('[')) {
    const auto list = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
    for (const auto& item : list)
      items.push_back(item.is_string() ? item.get<std::string>() : std::string());
    return items;
  }
  for (const std::string_view item : Split(text, ";")) items.emplace_back(Trim(Trim(item), "\""));
  return items;
}

std::string ItemOr(const Texts& items, size_t index, std::string otherwise = "") {
  return index < items.size() ? items[index] : std::move(otherwise);
}

bool SameText(std::string_view a, std::string_view b) {
  const auto first = ToNumber(a);
  const auto second = ToNumber(b);
  return first && second ? *first == *second : Trim(a) == Trim(b);
}

class ChangesReader {
 public:
  ChangesReader(const Project& project, size_t filament, const PresetSet& set)
      : filament_(filament),
        set_(set),
        dialect_(project.dialect == SettingsDialect::kOrca ? PresetDialect::kOrca
                                                           : PresetDialect::kPrusa) {
    for (const Setting& setting : project.settings) by_key_[setting.key] = setting.value;
  }

  DesignerChanges Read() && {
    changes_.nozzle_mm = FirstNumber(Value("nozzle_diameter"));
    changes_.former.layer_height = Value("layer_height");
    changes_.former.filament_type = ItemOr(AllItems(Value("filament_type")), filament_,
                                           ItemOr(AllItems(Value("filament_type")), 0));
    const Texts parents = AllItems(
        Value(dialect_ == PresetDialect::kOrca ? "inherits_group" : "inherits_cummulative"));
    TakeNames(parents);
    if (dialect_ == PresetDialect::kOrca) {
      TakeList(parents);
    } else {
      TakeDifferences(parents);
    }
    return std::move(changes_);
  }

 private:
  std::string Value(std::string_view key) const {
    const auto found = by_key_.find(key);
    return found == by_key_.end() ? std::string() : found->second;
  }

  /// Name of the preset that the project was made with.
  std::string NameOf(PresetKind kind) const {
    if (kind == PresetKind::kProcess) return Unescape(Value("print_settings_id"));
    const Texts names = AllItems(Value("filament_settings_id"));
    return ItemOr(names, filament_, ItemOr(names, 0));
  }

  /// A preset of a user has the alias of its parent.
  void TakeNames(const Texts& parents) {
    const std::string process = ItemOr(parents, 0);
    const std::string filament = ItemOr(parents, filament_ + 1);
    changes_.former.process_alias =
        AliasOf(process.empty() ? NameOf(PresetKind::kProcess) : process);
    changes_.former.filament_alias =
        AliasOf(filament.empty() ? NameOf(PresetKind::kFilament) : filament);
  }

  void TakeList(const Texts& parents) {
    const Texts lists = AllItems(Value("different_settings_to_system"));
    const std::string of_process = ItemOr(lists, 0);
    const std::string name = NameOf(PresetKind::kProcess);
    const bool of_vendor =
        ItemOr(parents, 0).empty() &&
        (name.find('@') != std::string::npos || !set_.Named(PresetKind::kProcess, name).empty());
    if (of_process.empty() && !of_vendor) return TakePart();
    Take(of_process, changes_.process);
    if (lists.size() > filament_ + 2) Take(lists[filament_ + 1], changes_.filament);
    if (lists.size() > 1)
      for (const std::string_view key : Split(lists.back(), ";"))
        if (!key.empty()) changes_.of_printer.emplace_back(key);
  }

  void Take(std::string_view keys, std::vector<Setting>& changes) const {
    for (const std::string_view key : Split(keys, ";"))
      if (const auto found = by_key_.find(key); found != by_key_.end())
        changes.push_back(SettingOf(found->first, found->second));
  }

  /// Returns a setting of the project; of a list of filaments, the item of the printing one.
  Setting SettingOf(const std::string& key, const std::string& value) const {
    const bool list = dialect_ == PresetDialect::kOrca && value.starts_with('[') &&
                      MayHaveKey(PresetKind::kFilament, dialect_, key) &&
                      !MayHaveKey(PresetKind::kProcess, dialect_, key);
    if (!list) return {key, value, Source::kProfile};
    const Texts items = AllItems(value);
    const nlohmann::json one = {ItemOr(items, filament_, ItemOr(items, 0))};
    return {key, one.dump(), Source::kProfile};
  }

  void TakeDifferences(const Texts& parents) {
    const Preset* process = BaseOf(PresetKind::kProcess, ItemOr(parents, 0));
    if (process == nullptr) return TakePart();
    TakeDifferences(*process, changes_.process);
    const Preset* filament = BaseOf(PresetKind::kFilament, ItemOr(parents, filament_ + 1));
    if (filament != nullptr) TakeDifferences(*filament, changes_.filament);
  }

  const Preset* BaseOf(PresetKind kind, const std::string& parent) const {
    for (const std::string& name : {NameOf(kind), parent})
      for (const Preset* preset : set_.Named(kind, name))
        if (preset->dialect != PresetDialect::kOrca) return preset;
    return nullptr;
  }

  void TakeDifferences(const Preset& base, std::vector<Setting>& changes) const {
    const auto flat = set_.Flatten(base);
    if (!flat.ok()) return;
    for (const auto& [key, value] : *flat) {
      const auto own = by_key_.find(key);
      const bool counts = MayHaveKey(base.kind, dialect_, key) && own != by_key_.end() &&
                          !key.starts_with("compatible_") && key != "inherits";
      if (counts && !SameText(own->second, value.value))
        changes.push_back({key, own->second, Source::kProfile});
    }
  }

  /// Takes all settings that describe the part.
  void TakePart() {
    changes_.unknown = true;
    for (const auto& [key, value] : by_key_)
      if (DescribesPart(dialect_, key)) changes_.process.push_back({key, value, Source::kProfile});
  }

  const size_t filament_;
  const PresetSet& set_;
  const PresetDialect dialect_;
  std::map<std::string, std::string, std::less<>> by_key_;
  DesignerChanges changes_;
};

}  // namespace

DesignerChanges ChangesOf(const Project& project, size_t filament, const PresetSet& set) {
  return ChangesReader(project, filament, set).Read();
}

}  // namespace slicefarm::config::presets
