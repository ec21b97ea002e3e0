#include "common/config/projects/project.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/projects/orca_settings.h"

namespace slicefarm::config {
namespace {

using Settings = std::vector<Setting>;

void SetSource(Source source, Settings& settings) {
  for (Setting& setting : settings) setting.source = source;
}

/// Translator for the settings of a project in OrcaSlicer's dialect.
class Translator {
 public:
  Translator(Project& project, size_t filament)
      : filament_(filament), project_(project), project_settings_(project.settings) {
    SetSource(Source::kProfile, project_settings_);
  }

  /// Translates all settings. Returns the settings without effect that change the print; they are
  /// first in Project::without_effect.
  std::vector<std::string> Run() {
    project_.settings = OfProject();
    for (ProjectPlate& plate : project_.plates) Translate(plate.name, plate.settings);
    for (SceneObject& object : project_.objects) {
      Translate(object.name, object.settings);
      for (Part& part : object.parts) Translate(object.name + ", " + part.name, part.settings);
      for (HeightRange& range : object.ranges)
        Translate(fmt::format("{}, {} mm to {} mm", object.name, range.from_mm, range.to_mm),
                  range.settings);
    }
    project_.without_effect.insert(project_.without_effect.end(), of_print_.begin(),
                                   of_print_.end());
    std::ranges::move(others_, std::back_inserter(project_.without_effect));
    return std::move(of_print_);
  }

 private:
  Settings OfProject() {
    OrcaUnused unused;
    Settings settings = FromOrca(project_settings_, &unused, filament_);
    Report("", unused);
    for (const auto* texts : {&unused.of_print, &unused.others})
      reported_.insert(texts->begin(), texts->end());
    return settings;
  }

  /// Translates the settings of a plate, object, part or range. Percentages refer to settings of
  /// the project, so the settings of the project are included; the source distinguishes both kinds.
  void Translate(const std::string& place, Settings& own) {
    if (own.empty()) return;
    SetSource(Source::kRequest, own);
    Settings all = project_settings_;
    all.insert(all.end(), own.begin(), own.end());
    OrcaUnused unused;
    own = FromOrca(all, &unused, filament_);
    for (auto* texts : {&unused.of_print, &unused.others})
      std::erase_if(*texts, [this](const std::string& text) { return reported_.contains(text); });
    Report(place, unused);
    std::erase_if(own, [](const Setting& setting) { return setting.source != Source::kRequest; });
  }

  void Report(const std::string& place, const OrcaUnused& unused) {
    const auto add = [&](const std::string& text, std::vector<std::string>& lines) {
      lines.push_back(place.empty() ? text : place + ": " + text);
    };
    for (const std::string& text : unused.of_print) add(text, of_print_);
    for (const std::string& text : unused.others) add(text, others_);
  }

  const size_t filament_;                       ///< number of the printing filament, from 0
  std::vector<std::string> of_print_, others_;  ///< settings without effect
  Project& project_;
  Settings project_settings_;
  std::set<std::string> reported_;  ///< settings of the project that are already reported
};

/// Returns true if the setting only requests the tool that the surroundings of the part use anyway.
bool IsUsualTool(const Setting& setting) {
  return setting.key == "extruder" && setting.value == "0";
}

void MakeProfile(Settings& settings) {
  SetSource(Source::kProfile, settings);
  std::erase_if(settings, IsUsualTool);
}

void MakeProfiles(Project& project) {
  MakeProfile(project.settings);
  for (ProjectPlate& plate : project.plates) MakeProfile(plate.settings);
  for (SceneObject& object : project.objects) {
    MakeProfile(object.settings);
    for (Part& part : object.parts) MakeProfile(part.settings);
    for (HeightRange& range : object.ranges) MakeProfile(range.settings);
  }
}

absl::Status NotAPlate(const Project& project, const std::string& message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message,
                   {{"field", "plate"}, {"plates", fmt::format("{}", project.plates.size())}});
}

std::string PlatesText(const Project& project) {
  std::string text;
  for (size_t i = 0; i < project.plates.size(); ++i) {
    if (project.plates[i].members.empty()) continue;
    const std::string& name = project.plates[i].name;
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", i + 1,
                        name.empty() ? "" : " (\"" + absl::Utf8SafeCEscape(name) + "\")");
  }
  return text;
}

/// Returns the index of the chosen plate, from 0. A project without plates has one plate.
absl::StatusOr<size_t> ChosenPlate(const Project& project, int plate) {
  const auto count = std::max<size_t>(project.plates.size(), 1);
  if (plate < 0 || static_cast<size_t>(plate) > count) {
    return NotAPlate(
        project,
        fmt::format("the project has no plate {}: the number of its plates is {}", plate, count));
  }
  if (plate > 0) return static_cast<size_t>(plate) - 1;
  const auto is_used = [](const ProjectPlate& each) { return !each.members.empty(); };
  if (std::ranges::count_if(project.plates, is_used) > 1) {
    return NotAPlate(project,
                     "the project has several plates, but a job prints only one; choose from " +
                         PlatesText(project));
  }
  const auto used = std::ranges::find_if(project.plates, is_used);
  return used == project.plates.end() ? 0 : static_cast<size_t>(used - project.plates.begin());
}

/// Returns the indices of the objects that have a printable copy on the plate.
std::set<int32_t> IndicesOn(const Project& project, size_t plate) {
  std::set<int32_t> printed;
  const auto add = [&](size_t object, const Instance& instance) {
    if (instance.printable) printed.insert(static_cast<int32_t>(object));
  };
  if (project.plates.empty()) {
    for (size_t i = 0; i < project.objects.size(); ++i)
      for (const Instance& instance : project.objects[i].instances) add(i, instance);
    return printed;
  }
  for (const ProjectPlate::Member& member : project.plates[plate].members) {
    const auto object = static_cast<size_t>(member.object);
    add(object, project.objects[object].instances[static_cast<size_t>(member.instance)]);
  }
  return printed;
}

/// Returns a missing feature if objects of the plate are painted with several filaments.
std::vector<MissingFeature> MissingOn(const Project& project, size_t plate) {
  const std::set<int32_t> printed = IndicesOn(project, plate);
  std::string names;
  for (const int32_t object : project.painted)
    if (printed.contains(object))
      names += fmt::format("{}`{}`", names.empty() ? "" : ", ",
                           project.objects[static_cast<size_t>(object)].name);
  if (names.empty()) return {};
  return {{std::string(kPaintedFilaments),
           "several filaments are painted on " + names + ", but a job prints with one filament",
           {{"objects", names}}}};
}

std::vector<SceneObject> ObjectsOn(const Project& project, size_t plate) {
  std::vector<SceneObject> objects = project.objects;
  if (!project.plates.empty()) {
    for (SceneObject& object : objects) object.instances.clear();
    for (const ProjectPlate::Member& member : project.plates[plate].members) {
      const auto object = static_cast<size_t>(member.object);
      objects[object].instances.push_back(
          project.objects[object].instances[static_cast<size_t>(member.instance)]);
    }
  }
  for (SceneObject& object : objects)
    std::erase_if(object.instances, [](const Instance& instance) { return !instance.printable; });
  std::erase_if(objects, [](const SceneObject& object) { return object.instances.empty(); });
  return objects;
}

/// Returns the number of the filament of `objects`, from 0. If they use several filaments, returns
/// the first one: such a plate is refused later (plate_tool.h).
size_t FilamentOf(const std::vector<SceneObject>& objects) {
  double least = 0;
  const auto look = [&least](const Settings& settings) {
    for (const Setting& setting : settings) {
      const double number = setting.key == "extruder" ? ToNumber(setting.value).value_or(0) : 0;
      if (number >= 1 && (least == 0 || number < least)) least = number;
    }
  };
  for (const SceneObject& object : objects) {
    const bool says_itself = std::ranges::all_of(object.parts, [](const Part& part) {
      return std::ranges::any_of(part.settings, [](const Setting& setting) {
        return setting.key == "extruder" && !IsUsualTool(setting);
      });
    });
    if (object.parts.empty() || !says_itself) look(object.settings);
    for (const Part& part : object.parts) look(part.settings);
  }
  return least < 1 ? 0 : static_cast<size_t>(least) - 1;
}

/// Converts the project to PrusaSlicer's names. `printed`: objects of the job. Returns the settings
/// without effect that change the print.
std::vector<std::string> TakePrusaNames(const std::vector<SceneObject>& printed, Project& project) {
  std::vector<std::string> of_print;
  if (project.dialect == SettingsDialect::kOrca)
    of_print = Translator(project, FilamentOf(printed)).Run();
  project.dialect = SettingsDialect::kPrusa;
  MakeProfiles(project);
  return of_print;
}

}  // namespace

absl::StatusOr<size_t> FilamentOf(const Project& project, int plate) {
  const absl::StatusOr<size_t> chosen = ChosenPlate(project, plate);
  if (!chosen.ok()) return chosen.status();
  return FilamentOf(ObjectsOn(project, *chosen));
}

Project InPrusaNames(Project project) {
  TakePrusaNames(project.objects, project);
  return project;
}

absl::StatusOr<ProjectJob> JobOfProject(const Project& given, int plate) {
  const absl::StatusOr<size_t> chosen = ChosenPlate(given, plate);
  if (!chosen.ok()) return chosen.status();
  Project project = given;
  const std::vector<std::string> of_print = TakePrusaNames(ObjectsOn(given, *chosen), project);
  ProjectJob job;
  job.objects = ObjectsOn(project, *chosen);
  if (job.objects.empty()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     fmt::format("plate {} has no object to print", *chosen + 1));
  }
  job.settings = std::move(project.settings);
  if (!project.plates.empty())
    std::ranges::move(project.plates[*chosen].settings, std::back_inserter(job.settings));
  job.without_effect = std::move(project.without_effect);
  job.missing = MissingOn(given, *chosen);
  for (const MissingFeature& each : job.missing)
    job.without_effect.insert(job.without_effect.begin(), each.text);
  for (const std::string& part : given.without_effect)
    job.warnings.push_back(part + ": without effect");
  for (const std::string& setting : of_print)
    job.warnings.push_back(setting + ": not supported yet");
  return job;
}

}  // namespace slicefarm::config
