#include "common/config/presets/target_printer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "common/base/text.h"
#include "common/config/presets/designer_changes.h"
#include "common/config/presets/portable_settings.h"
#include "common/config/projects/orca_settings.h"
#include "common/config/projects/project.h"

namespace slicefarm::config::presets {
namespace {

constexpr char kProject[] = "project";  // source of the designer's changes
constexpr std::string_view kHeightCodes = "custom_gcode_per_print_z";

/// Returns the value of a setting; an empty text if there is none.
template <typename Settings>
std::string LastValue(const Settings& settings, std::string_view key) {
  std::string value;
  for (const auto& setting : settings)
    if (setting.key == key) value = setting.value;
  return value;
}

/// Appends the changes, and removes the settings that they replace.
void Replace(std::vector<Setting>& settings, const std::vector<Setting>& changes) {
  std::erase_if(settings, [&](const Setting& setting) {
    return std::ranges::find(changes, setting.key, &Setting::key) != changes.end();
  });
  std::ranges::copy(changes, std::back_inserter(settings));
}

/// Bounding box of a bed, in mm.
struct BedBox {
  std::array<double, 2> min = {0, 0};
  std::array<double, 2> max = {0, 0};
  bool rectangular = false;

  double Middle(size_t axis) const { return (min[axis] + max[axis]) / 2; }
  double Size(size_t axis) const { return max[axis] - min[axis]; }
};

/// Reads the bed of settings in any dialect; nullopt if they have none.
template <typename Settings>
std::optional<BedBox> BedOf(const Settings& settings) {
  std::string text = LastValue(settings, "printable_area");
  if (text.empty()) text = LastValue(settings, "bed_shape");
  BedBox box;
  int corners = 0, at_edges = 0;
  std::vector<std::array<double, 2>> points;
  for (const std::string_view item : Split(text, ",")) {
    const std::vector<std::string_view> xy = Split(Trim(item, " []\""), "x");
    const auto x = xy.size() == 2 ? ToNumber(xy[0]) : std::nullopt;
    const auto y = xy.size() == 2 ? ToNumber(xy[1]) : std::nullopt;
    if (!x || !y) return std::nullopt;
    points.push_back({*x, *y});
    for (size_t axis = 0; axis < 2; ++axis) {
      box.min[axis] =
          corners == 0 ? points.back()[axis] : std::min(box.min[axis], points.back()[axis]);
      box.max[axis] =
          corners == 0 ? points.back()[axis] : std::max(box.max[axis], points.back()[axis]);
    }
    ++corners;
  }
  for (const auto& point : points)
    if ((point[0] == box.min[0] || point[0] == box.max[0]) &&
        (point[1] == box.min[1] || point[1] == box.max[1]))
      ++at_edges;
  box.rectangular = corners == 4 && at_edges == 4;
  return box;
}

/// Puts the objects on the new bed. Returns a note if they are to be arranged anew.
std::string MoveToBed(const std::optional<BedBox>& from, const std::optional<BedBox>& to,
                      std::vector<SceneObject>& objects) {
  if (!from || !to) return "";
  const auto same = [&](size_t axis) {
    return from->min[axis] == to->min[axis] && from->max[axis] == to->max[axis];
  };
  if (from->rectangular == to->rectangular && same(0) && same(1)) return "";
  const bool fits = from->rectangular && to->rectangular && from->Size(0) <= to->Size(0) &&
                    from->Size(1) <= to->Size(1);
  for (SceneObject& object : objects) {
    for (Instance& instance : object.instances) {
      if (!fits) instance.placed = false;
      for (int axis = 0; axis < 2 && fits; ++axis) {
        const auto i = static_cast<size_t>(axis);
        instance.to_plate(axis, 3) += to->Middle(i) - from->Middle(i);
      }
    }
  }
  if (fits) return "";
  return fmt::format(
      "the printer's bed of {:g} x {:g} mm is smaller than the project's bed of {:g} x {:g} mm: "
      "the objects are arranged again",
      to->Size(0), to->Size(1), from->Size(0), from->Size(1));
}

/// Reasons for settings that are left out, with their keys.
class LeftOut {
 public:
  void Add(const std::string& why, const std::string& key) {
    std::string& keys = keys_[why];
    if ((" " + keys + ",").find(" " + key + ",") != std::string::npos) return;
    keys += (keys.empty() ? "" : ", ") + ReplaceControls(key, '?');
  }

  std::vector<std::string> Lines() const {
    std::vector<std::string> lines;
    for (const auto& [why, keys] : keys_)
      lines.push_back(fmt::format("settings of the project that are not used ({}): {}", why, keys));
    return lines;
  }

 private:
  std::map<std::string, std::string> keys_;
};

class Converter {
 public:
  Converter(const PresetSet& set, TargetedProject& made, PrinterChange change)
      : set_(set), made_(made), change_(change) {}

  absl::Status Run(const DesignerChanges& changes, const std::vector<SourcedValue>& values) {
    Keep(PresetKind::kProcess, changes.process);
    Keep(PresetKind::kFilament, changes.filament);
    for (const std::string& key : changes.of_printer) left_out_.Add("belongs to the printer", key);
    for (ProjectPlate& plate : made_.project.plates) Filter(plate.settings);
    for (SceneObject& object : made_.project.objects) {
      Filter(object.settings);
      for (Part& part : object.parts) Filter(part.settings);
      for (HeightRange& range : object.ranges) Filter(range.settings);
    }
    const std::string codes = LastValue(made_.project.settings, kHeightCodes);
    absl::Status done = TakeSettings(values);
    if (!codes.empty())
      made_.project.settings.push_back({std::string(kHeightCodes), codes, Source::kProfile});
    for (std::string& line : left_out_.Lines()) made_.notes.push_back(std::move(line));
    return done;
  }

 private:
  void Keep(PresetKind kind, const std::vector<Setting>& changes) {
    for (const Setting& setting : changes) {
      const std::string why = WhyUnfit(kind, setting, change_);
      if (!why.empty()) {
        left_out_.Add(why, setting.key);
      } else {
        made_.kept.push_back(setting);
      }
    }
  }

  /// Removes settings of a plate or an object that do not fit the printer.
  void Filter(std::vector<Setting>& settings) {
    std::erase_if(settings, [&](const Setting& setting) {
      const std::string why = setting.key == "curr_bed_type"
                                  ? "belongs to the printer"
                                  : WhyUnfit(PresetKind::kProcess, setting, change_);
      if (!why.empty()) left_out_.Add(why, setting.key);
      return !why.empty();
    });
  }

  /// Replaces the project's settings by the presets' settings with the kept changes. If project and
  /// presets are of different programs, both get PrusaSlicer's names.
  absl::Status TakeSettings(const std::vector<SourcedValue>& values) {
    const bool orca_project = made_.project.dialect == SettingsDialect::kOrca;
    const bool orca = made_.presets.printer->dialect == PresetDialect::kOrca;
    if (orca && orca_project) {
      made_.project.settings.clear();
      for (const SourcedValue& each : values)
        made_.project.settings.push_back({each.key, each.value, Source::kProfile});
      Replace(made_.project.settings, made_.kept);
      std::vector<LabelledSetting> labelled = Labelled(values);
      for (const Setting& setting : made_.kept) labelled.push_back({setting, kProject});
      made_.sources = LastSources(SourcesOf(PresetDialect::kOrca, labelled));
      return absl::OkStatus();
    }
    auto job = SettingsOfPresets(set_, made_.presets);
    if (!job.ok()) return job.status();
    std::vector<Setting> kept = made_.kept;
    if (orca_project) kept = ToPrusaNames();
    made_.project.settings = std::move(job->settings);
    Replace(made_.project.settings, kept);
    made_.of_print = std::move(job->of_print);
    made_.others = std::move(job->others);
    made_.sources = std::move(job->sources);
    made_.sources.push_back(SourceOfAll(kProject, kept));
    made_.sources = LastSources(made_.sources);
    return absl::OkStatus();
  }

  /// Converts the objects of a project of OrcaSlicer, and returns the kept changes. Percentages
  /// refer to the project's own settings. Lines about other settings of the project are dropped.
  std::vector<Setting> ToPrusaNames() {
    std::vector<Setting> all = made_.project.settings;
    for (Setting& setting : all) setting.source = Source::kProfile;
    for (Setting setting : made_.kept) {
      setting.source = Source::kRequest;
      all.push_back(std::move(setting));
    }
    OrcaUnused unused;
    std::vector<Setting> kept = FromOrca(all, &unused);
    std::erase_if(kept, [](const Setting& each) { return each.source != Source::kRequest; });
    std::vector<std::string> lines = made_.project.without_effect;
    for (const auto* texts : {&unused.of_print, &unused.others})
      for (const std::string& text : *texts)
        if (!LastValue(made_.kept, KeyOfUnused(text)).empty()) lines.push_back(text);
    made_.project = InPrusaNames(std::move(made_.project));
    made_.project.without_effect = std::move(lines);
    return kept;
  }

  const PresetSet& set_;
  TargetedProject& made_;
  const PrinterChange change_;
  LeftOut left_out_;
};

PrinterChange ChangeOfPrinter(const DesignerChanges& changes,
                              const std::vector<SourcedValue>& values) {
  constexpr double kHighestLayer =
      0.75;  // part of the nozzle's diameter, if the printer has no limit
  PrinterChange change;
  change.from_nozzle_mm = changes.nozzle_mm;
  change.to_nozzle_mm = FirstNumber(LastValue(values, "nozzle_diameter"));
  change.min_layer_mm = FirstNumber(LastValue(values, "min_layer_height"));
  change.max_layer_mm = FirstNumber(LastValue(values, "max_layer_height"));
  if (change.max_layer_mm <= 0) change.max_layer_mm = kHighestLayer * change.to_nozzle_mm;
  const std::vector<std::string> type = ListItems(LastValue(values, "filament_type"));
  change.same_material = !type.empty() && type.front() == changes.former.filament_type;
  return change;
}

}  // namespace

absl::StatusOr<TargetedProject> ForPrinter(Project project, int plate, const PresetSet& set,
                                           const PresetNames& names) {
  const auto filament = FilamentOf(project, plate);
  if (!filament.ok()) return filament.status();
  const DesignerChanges changes = ChangesOf(project, *filament, set);
  auto chosen = ChoosePresets(set, names, changes.former);
  if (!chosen.ok()) return chosen.status();
  const auto values = CombinePresets(set, *chosen);
  if (!values.ok()) return values.status();
  TargetedProject made;
  made.presets = *std::move(chosen);
  made.notes = made.presets.notes;
  if (changes.unknown)
    made.notes.push_back(
        "the project does not list the settings that its designer changed: the project's settings "
        "of shells, infill, supports, brim and surface are kept");
  const double height = ToNumber(changes.former.layer_height).value_or(0);
  const double own = FirstNumber(LastValue(*values, "layer_height"));
  const bool changed = !LastValue(changes.process, "layer_height").empty();
  if (names.process.empty() && !changed && height > 0 && std::abs(height - own) > 1e-6)
    made.notes.push_back(
        fmt::format("no process preset of the printer has the project's layer height of {} mm: "
                    "\"{}\" with {} mm is used",
                    height, ReplaceControls(made.presets.process->name, '?'), own));
  std::string moved = MoveToBed(BedOf(project.settings), BedOf(*values), project.objects);
  if (!moved.empty()) made.notes.push_back(std::move(moved));
  made.project = std::move(project);
  absl::Status done = Converter(set, made, ChangeOfPrinter(changes, *values)).Run(changes, *values);
  if (!done.ok()) return done;
  return made;
}

}  // namespace slicefarm::config::presets
