#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset.h"

namespace slicefarm::config::presets {

/// Value of a setting and the preset that has it.
struct FlatValue {
  std::string value;
  const Preset* from = nullptr;
};
using FlatPreset = std::map<std::string, FlatValue, std::less<>>;

/// All presets of all sources. Names of parents are looked up in the set.
class PresetSet {
 public:
  /// Limits on inheritance: generations above a preset, and presets that one preset inherits from.
  static constexpr int kMaxGenerations = 64;
  static constexpr size_t kMaxAncestors = 1'000;

  /// Adds a group of presets and returns its index.
  int32_t AddScope(PresetScope scope);
  void Add(Preset preset);
  void Add(PrinterModel model);
  /// Adds a message about a file, or a part of a file, that is not used.
  void AddProblem(std::string line) { problems_.push_back(std::move(line)); }

  const std::vector<Preset>& presets() const { return presets_; }
  const std::vector<std::string>& problems() const { return problems_; }
  const PresetScope& ScopeOf(const Preset& preset) const { return scopes_[preset.scope]; }
  /// Returns the model of a printer preset, or nullptr.
  const PrinterModel* ModelOf(const Preset& printer) const;

  /// Returns the listed presets of a kind with this name, followed by the presets that have the
  /// name as an old name. Both groups are in the order in which presets were added.
  std::vector<const Preset*> Named(PresetKind kind, std::string_view name) const;

  /// Returns the preset, followed by its ancestors. If several of them have a setting, the first in
  /// this list counts. Errors: PROFILE_NOT_FOUND for a missing parent (metadata `preset`,
  /// `parent`); SETTING_MALFORMED for a preset that inherits from itself; REQUEST_TOO_LARGE beyond
  /// the limits. Cost: O(ancestors).
  absl::StatusOr<std::vector<const Preset*>> Lineage(const Preset& preset) const;

  /// Returns all settings of a preset, including inherited ones. Errors: any error of Lineage.
  absl::StatusOr<FlatPreset> Flatten(const Preset& preset) const;

  /// Returns the value of a setting for the preset with this result of Lineage; an empty text if no
  /// preset of the lineage has the setting.
  static std::string_view ValueOf(const std::vector<const Preset*>& lineage, std::string_view key);

 private:
  class Walk;

  /// Indices of the first listed presets with a name. They are kept because a search among all
  /// presets with the name would take quadratic time.
  struct Namesakes {
    std::optional<size_t> first;
    std::optional<size_t> first_of_user;
  };

  void NoteName(const Preset& preset);
  const Preset* ParentOf(const Preset& child, std::string_view name) const;
  const Preset* InScope(int32_t scope, PresetKind kind, std::string_view name) const;

  std::vector<PresetScope> scopes_;
  std::vector<Preset> presets_;
  std::vector<PrinterModel> models_;
  std::vector<std::string> problems_;
  /// Indices into presets_ by kind and name (by_name_), and by kind and old name (by_old_name_).
  std::multimap<std::pair<PresetKind, std::string>, size_t> by_name_, by_old_name_;
  std::map<std::pair<PresetKind, std::string>, Namesakes>
      namesakes_;  ///< namesakes by kind and name
};

}  // namespace slicefarm::config::presets
