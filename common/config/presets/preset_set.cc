#include "common/config/presets/preset_set.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>

#include "common/base/error.h"

namespace slicefarm::config::presets {
namespace {

/// Vendor of the filaments that presets of all vendors of OrcaSlicer may inherit from.
constexpr std::string_view kFilamentLibrary = "OrcaFilamentLibrary";

absl::Status MissingParent(const Preset& child, const std::string& parent) {
  return MakeError(
      absl::StatusCode::kNotFound, Reason::kProfileNotFound,
      fmt::format("the {} preset \"{}\" inherits from \"{}\", which is not among the given "
                  "presets; give the folder of the program's own presets, too",
                  KindName(child.kind), child.name, parent),
      {{"preset", child.name}, {"parent", parent}});
}

absl::Status OwnAncestor(const Preset& preset) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
      fmt::format("the {} preset \"{}\" inherits from itself", KindName(preset.kind), preset.name),
      {{"preset", preset.name}});
}

}  // namespace

/// Depth-first walk over the ancestors of a preset. Of a preset's parents, the last one is visited
/// first.
class PresetSet::Walk {
 public:
  explicit Walk(const PresetSet& set) : set_(set) {}

  absl::Status Visit(const Preset& preset, int generation) {
    if (generation > kMaxGenerations)
      return LimitError(Reason::kRequestTooLarge, "generations of presets", kMaxGenerations,
                        generation);
    if (open_.contains(&preset)) return OwnAncestor(preset);
    // A preset that was visited before is already in the lineage, at a position with precedence.
    if (!seen_.insert(&preset).second) return absl::OkStatus();
    if (seen_.size() > kMaxAncestors)
      return LimitError(Reason::kRequestTooLarge, "presets that a preset inherits from",
                        kMaxAncestors, static_cast<int64_t>(seen_.size()));
    lineage_.push_back(&preset);
    open_.insert(&preset);
    for (auto name = preset.parents.rbegin(); name != preset.parents.rend(); ++name) {
      const Preset* parent = set_.ParentOf(preset, *name);
      if (parent == nullptr && preset.complete) continue;
      if (parent == nullptr) return MissingParent(preset, *name);
      if (absl::Status status = Visit(*parent, generation + 1); !status.ok()) return status;
    }
    open_.erase(&preset);
    return absl::OkStatus();
  }

  std::vector<const Preset*> Take() && { return std::move(lineage_); }

 private:
  const PresetSet& set_;
  std::vector<const Preset*> lineage_;
  std::set<const Preset*> seen_;
  std::set<const Preset*> open_;  ///< presets on the current path of the visit
};

int32_t PresetSet::AddScope(PresetScope scope) {
  scopes_.push_back(std::move(scope));
  return static_cast<int32_t>(scopes_.size()) - 1;
}

/// Records the name of a listed preset. Adds a problem if a preset of a user and another preset
/// have the same name: the name can choose only one of them.
void PresetSet::NoteName(const Preset& preset) {
  if (!preset.listed) return;
  const bool is_users = ScopeOf(preset).vendor.empty();
  Namesakes& namesakes = namesakes_[std::pair(preset.kind, preset.name)];
  const std::optional<size_t> other = is_users ? namesakes.first : namesakes.first_of_user;
  if (!namesakes.first) namesakes.first = presets_.size();
  if (is_users && !namesakes.first_of_user) namesakes.first_of_user = presets_.size();
  if (!other) return;
  AddProblem(
      fmt::format("{}: the {} preset \"{}\" is also in {}; the name chooses only one of them",
                  preset.file, KindName(preset.kind), preset.name, presets_[*other].file));
}

void PresetSet::Add(Preset preset) {
  NoteName(preset);
  by_name_.emplace(std::pair(preset.kind, preset.name), presets_.size());
  for (const std::string& name : preset.old_names)
    by_old_name_.emplace(std::pair(preset.kind, name), presets_.size());
  presets_.push_back(std::move(preset));
}

void PresetSet::Add(PrinterModel model) { models_.push_back(std::move(model)); }

const PrinterModel* PresetSet::ModelOf(const Preset& printer) const {
  const auto lineage = Lineage(printer);
  if (!lineage.ok()) return nullptr;
  const std::string_view id = ValueOf(*lineage, "printer_model");
  const PrinterModel* found = nullptr;
  for (const PrinterModel& model : models_) {
    if (model.id != id) continue;
    if (model.scope == printer.scope) return &model;
    if (found == nullptr) found = &model;
  }
  return found;
}

std::vector<const Preset*> PresetSet::Named(PresetKind kind, std::string_view name) const {
  std::vector<const Preset*> found;
  for (const auto* names : {&by_name_, &by_old_name_}) {
    const auto [first, last] = names->equal_range(std::pair(kind, std::string(name)));
    std::vector<size_t> indices;
    for (auto at = first; at != last; ++at) indices.push_back(at->second);
    std::sort(indices.begin(), indices.end());
    for (const size_t index : indices)
      if (presets_[index].listed) found.push_back(&presets_[index]);
  }
  return found;
}

const Preset* PresetSet::InScope(int32_t scope, PresetKind kind, std::string_view name) const {
  const auto [first, last] = by_name_.equal_range(std::pair(kind, std::string(name)));
  for (auto at = first; at != last; ++at)
    if (presets_[at->second].scope == scope) return &presets_[at->second];
  return nullptr;
}

/// Returns the parent with this name. It is looked up in the child's own scope first, then in the
/// library of filaments for vendors' filaments, or in all listed presets for presets of a user.
const Preset* PresetSet::ParentOf(const Preset& child, std::string_view name) const {
  if (const Preset* own = InScope(child.scope, child.kind, name); own != nullptr && own != &child)
    return own;
  if (ScopeOf(child).vendor.empty()) {
    for (const Preset* preset : Named(child.kind, name))
      if (preset != &child) return preset;
  } else if (child.kind == PresetKind::kFilament && child.dialect == PresetDialect::kOrca) {
    for (size_t i = 0; i < scopes_.size(); ++i)
      if (scopes_[i].vendor == kFilamentLibrary)
        return InScope(static_cast<int32_t>(i), child.kind, name);
  }
  return name == child.name ? &child : nullptr;
}

absl::StatusOr<std::vector<const Preset*>> PresetSet::Lineage(const Preset& preset) const {
  Walk walk(*this);
  if (absl::Status status = walk.Visit(preset, 0); !status.ok()) return status;
  return std::move(walk).Take();
}

absl::StatusOr<FlatPreset> PresetSet::Flatten(const Preset& preset) const {
  const auto lineage = Lineage(preset);
  if (!lineage.ok()) return lineage.status();
  FlatPreset flat;
  for (const Preset* each : *lineage)
    for (auto setting = each->settings.rbegin(); setting != each->settings.rend(); ++setting)
      flat.try_emplace(setting->key, FlatValue{setting->value, each});
  return flat;
}

std::string_view PresetSet::ValueOf(const std::vector<const Preset*>& lineage,
                                    std::string_view key) {
  for (const Preset* each : lineage)
    for (auto setting = each->settings.rbegin(); setting != each->settings.rend(); ++setting)
      if (setting->key == key) return setting->value;
  return "";
}

}  // namespace slicefarm::config::presets
