#include "services/cli/models/given_models.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/config/plate.h"
#include "common/config/presets/target_printer.h"
#include "common/config/projects/project.h"
#include "common/model/limits.h"
#include "common/model/scene/placement.h"
#include "services/cli/console/files.h"
#include "services/cli/console/model_file.h"
#include "services/cli/job/joined_plates.h"
#include "services/cli/models/model_arguments.h"
#include "services/cli/models/preset_sources.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/placement/local_arranging_stage.h"

namespace slicefarm::cli {
namespace {

/// Object with its names for the command line.
struct NamedObject {
  SceneObject object;
  std::vector<std::string> names;  ///< the names of its file, and its own name

  bool IsCalled(const std::string& name) const {
    return std::ranges::find(names, name) != names.end();
  }
  bool IsPlaced() const {
    return std::ranges::any_of(object.instances,
                               [](const Instance& instance) { return instance.placed; });
  }
};

/// Returns the ending of a file's name, in lower case.
std::string EndingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

/// Checks a name that ends in .3mf. Other programs choose the format by the name and would report
/// that the file is no 3MF. Detection by content alone would report a broken binary STL.
absl::Status CheckName(const std::string& path, const MeshFile& model, MeshFormat format) {
  if (EndingOf(path) != ".3mf" || format == MeshFormat::k3mf || format == MeshFormat::kUnknown ||
      model.bytes.empty())
    return absl::OkStatus();
  return InFile(path, MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshFormatUnknown,
                                "not a 3MF project: the file does not begin like a ZIP archive"));
}

/// Reads the models for one plate.
class PlateReader {
 public:
  /// `plate`: plate of a project. `presets`: presets that the job names, or nullptr.
  PlateReader(const JobOptions& options, int plate, const config::presets::PresetSet* presets)
      : options_(options), chosen_(plate), presets_(presets) {}

  absl::StatusOr<GivenModels> Run() && {
    const auto placement = PlacementOf(options_);
    if (!placement.ok()) return placement.status();
    if (absl::Status ok = CheckPlacement(*placement); !ok.ok()) return ok;
    placement_ = *placement;
    for (const std::string& path : options_.models)
      if (absl::Status ok = Read(path); !ok.ok()) return ok;
    if (chosen_ > 0 && !has_project_)
      return Malformed(
          "--plate works only with a 3MF project: give a project as MODEL, or omit --plate");
    absl::Status ok = TakeCopies();
    if (ok.ok()) ok = TakeSettings();
    if (ok.ok() && presets_ != nullptr && !for_printer_)
      ok = TakePresets(*presets_, options_.presets, plate_);
    if (!ok.ok()) return ok;
    for (NamedObject& named : objects_) plate_.objects.push_back(std::move(named.object));
    given_.plates.push_back(std::move(plate_));
    return std::move(given_);
  }

 private:
  absl::Status Read(const std::string& path) {
    const auto [file, is_new] = files_.try_emplace(path, static_cast<int32_t>(given_.files.size()));
    if (is_new) {
      auto read = ReadModelFile(path);
      if (!read.ok()) return read.status();
      given_.files.push_back(*std::move(read));
    }
    const MeshFile& model = given_.files[static_cast<size_t>(file->second)];
    const MeshFormat format = slicing::DetectFormat(model.bytes);
    if (format == MeshFormat::k3mf) return AddProject(path, file->second);
    if (absl::Status ok = CheckName(path, model, format); !ok.ok()) return ok;
    Add(path, ObjectOfFile(NameOf(path), file->second, placement_, 0));
    return absl::OkStatus();
  }

  absl::Status AddProject(const std::string& path, int32_t file) {
    has_project_ = true;
    MeshFile& model = given_.files[static_cast<size_t>(file)];
    model.format = MeshFormat::k3mf;
    auto project = ReadProject(path, model);
    if (!project.ok()) return project.status();
    if (presets_ != nullptr && !project->settings.empty())
      if (absl::Status ok = MakeForPrinter(*project); !ok.ok()) return InFile(path, ok);
    auto job = config::JobOfProject(*project, chosen_);
    if (!job.ok()) return InFile(path, job.status());
    for (SceneObject& object : job->objects) {
      for (Part& part : object.parts) part.mesh.file = file;
      if (options_.arrange)
        for (Instance& instance : object.instances) instance.placed = false;
      if (absl::Status ok = PlaceAgain(path, job->objects.size(), object); !ok.ok()) return ok;
      Add(path, std::move(object));
    }
    std::ranges::move(job->settings, std::back_inserter(plate_.settings));
    std::ranges::move(job->without_effect, std::back_inserter(plate_.without_effect));
    std::ranges::move(job->warnings, std::back_inserter(plate_.warnings));
    std::ranges::move(job->missing, std::back_inserter(plate_.missing));
    return absl::OkStatus();
  }

  /// Converts a project with settings for the printer that the job names.
  absl::Status MakeForPrinter(Project& project) {
    auto made = config::presets::ForPrinter(std::move(project), chosen_, *presets_,
                                            NamesOf(options_.presets));
    if (!made.ok()) return made.status();
    project = std::move(made->project);
    plate_.presets = FullNames(made->presets);
    AddUnused(made->of_print, made->others, plate_);
    std::ranges::move(made->notes, std::back_inserter(plate_.warnings));
    std::ranges::move(made->sources, std::back_inserter(plate_.sources));
    for_printer_ = true;
    return absl::OkStatus();
  }

  /// Applies the position of the command line, if there is one, to an object of a project.
  absl::Status PlaceAgain(const std::string& path, size_t objects, SceneObject& object) const {
    if (placement_.unit_mm != 1)
      return Malformed("--units: omit this option, because the unit of " + path +
                       " is stored in the file");
    const std::vector<Point>& centers = placement_.centers;
    Placement turn = placement_;
    turn.centers.clear();
    if (turn == Placement() && centers.empty()) return absl::OkStatus();
    for (Instance& instance : object.instances) {
      if (instance.placed) {
        return Malformed(
            fmt::format("--scale, --rotate, --rotate-z and --center would change the positions of "
                        "objects in {}; add --arrange to arrange all objects again",
                        path));
      }
      instance.to_plate = Combined(TransformOf(turn), instance.to_plate);
    }
    if (centers.empty()) return absl::OkStatus();
    if (objects != 1 || object.instances.size() != 1)
      return Malformed(
          fmt::format("--center: {} has several objects or copies; use --arrange instead", path));
    Instance instance = object.instances.front();
    instance.placed = instance.by_middle = true;
    object.instances.clear();
    for (const Point center : centers) {
      instance.to_plate(0, 3) = ToMm(static_cast<double>(center.x));
      instance.to_plate(1, 3) = ToMm(static_cast<double>(center.y));
      object.instances.push_back(instance);
    }
    return absl::OkStatus();
  }

  void Add(const std::string& path, SceneObject object) {
    NamedObject named{std::move(object), {path, NameOf(path)}};
    named.names.push_back(named.object.name);
    objects_.push_back(std::move(named));
  }

  std::vector<std::string> KnownNames() const {
    std::vector<std::string> names;
    for (const NamedObject& named : objects_)
      names.insert(names.end(), named.names.begin(), named.names.end());
    return names;
  }

  absl::Status TakeCopies() {
    for (const std::string& text : options_.copies) {
      const OfModel of = TakeApart(text, '=', KnownNames());
      const auto count = CopiesOf(text, of);
      if (!count.ok()) return count.status();
      if (!options_.centers.empty()) return Malformed("--copies and --center exclude each other");
      for (NamedObject& named : objects_) {
        if (!named.IsCalled(of.name)) continue;
        if (named.IsPlaced()) {
          return Malformed(
              fmt::format("--copies {}: the project already has a position for this object; add "
                          "--arrange to arrange all copies",
                          text));
        }
        named.object.instances.assign(static_cast<size_t>(*count), named.object.instances.front());
      }
    }
    return absl::OkStatus();
  }

  absl::Status TakeSettings() {
    for (const std::string& text : options_.object_sets) {
      const OfModel of = TakeApart(text, ':', KnownNames());
      if (of.name.empty()) {
        return Malformed(fmt::format(
            "--object-set {}: MODEL:KEY=VALUE is needed, with the name of one of the models",
            text));
      }
      const auto setting = ParseSet("--object-set", of.what);
      if (!setting.ok()) return setting.status();
      for (NamedObject& named : objects_)
        if (named.IsCalled(of.name)) named.object.settings.push_back(*setting);
    }
    return absl::OkStatus();
  }

  const JobOptions& options_;
  const int chosen_;
  const config::presets::PresetSet* const presets_;
  bool for_printer_ = false;  ///< true if a project has the settings of the presets
  Placement placement_;
  GivenModels given_;
  GivenPlate plate_;
  std::vector<NamedObject> objects_;
  std::map<std::string, int32_t> files_;  ///< index of the file, by path
  bool has_project_ = false;
};

/// Returns the plates of a project to print, from 1; {0} for other models.
absl::StatusOr<std::vector<int>> PlatesToPrint(const JobOptions& options) {
  std::vector<int> plates;
  if (options.models.size() == 1) {
    const auto file = ReadModelFile(options.models[0]);
    if (!file.ok()) return file.status();
    if (slicing::DetectFormat(file->bytes) == MeshFormat::k3mf) {
      const auto project = ReadProject(options.models[0], *file);
      if (!project.ok()) return project.status();
      for (size_t i = 0; i < project->plates.size(); ++i)
        if (!project->plates[i].members.empty()) plates.push_back(static_cast<int>(i) + 1);
    }
  }
  if (plates.empty()) plates.push_back(0);
  return plates;
}

/// Distributes the plate's copies over as many beds as needed.
absl::StatusOr<std::vector<GivenPlate>> OnBeds(const std::vector<MeshFile>& files,
                                               const GivenPlate& plate,
                                               const std::vector<Setting>& given, Process process) {
  const auto resolved = config::ResolvePlate(SettingsOf(plate, given), plate.objects, process);
  if (!resolved.ok()) return resolved.status();
  const auto positions = slicing::MakeLocalArranging()->PutOnPlates(
      {}, {files, ObjectsToArrange(plate.objects)}, resolved->settings.slicing);
  if (!positions.ok()) return positions.status();
  std::vector<GivenPlate> plates;
  for (std::vector<SceneObject>& objects : OnPlates(plate.objects, *positions)) {
    plates.push_back(plate);
    plates.back().objects = std::move(objects);
  }
  return plates;
}

absl::StatusOr<GivenModels> ReadAllPlates(const JobOptions& options,
                                          const config::presets::PresetSet* presets) {
  const auto numbers = PlatesToPrint(options);
  if (!numbers.ok()) return numbers.status();
  GivenModels all;
  for (const int number : *numbers) {
    auto one = PlateReader(options, number, presets).Run();
    if (!one.ok() && DetailOf(one.status()).reason == Reason::kNothingToPrint) {
      all.plates.push_back({.number = number, .refused = one.status()});
      continue;
    }
    if (!one.ok()) return one.status();
    all.files = std::move(one->files);
    for (GivenPlate& plate : one->plates) {
      plate.number = number;
      all.plates.push_back(std::move(plate));
    }
  }
  return all;
}

}  // namespace

bool HasProject(const JobOptions& options) {
  return std::ranges::any_of(options.models,
                             [](const std::string& path) { return EndingOf(path) == ".3mf"; });
}

absl::StatusOr<GivenModels> ReadModels(const JobOptions& options,
                                       const config::presets::PresetSet* presets) {
  std::optional<config::presets::PresetSet> set;
  if (!options.presets.sources.empty()) {
    auto read = ReadPresetSources(options.presets.sources);
    if (!read.ok()) return read.status();
    set = *std::move(read);
  }
  if (set) presets = &*set;
  return options.plates ? ReadAllPlates(options, presets)
                        : PlateReader(options, options.plate, presets).Run();
}

void PutOnBeds(const JobOptions& options, const std::vector<Setting>& given, GivenModels& models) {
  if (!options.plates) return;
  std::vector<GivenPlate> all;
  for (GivenPlate& plate : models.plates) {
    if (plate.refused.ok()) {
      auto beds = OnBeds(models.files, plate, given, options.process);
      plate.refused = beds.status();
      if (beds.ok()) std::ranges::move(*beds, std::back_inserter(all));
    }
    if (!plate.refused.ok()) all.push_back(std::move(plate));
  }
  models.plates = std::move(all);
}

absl::Status OfPlate(const GivenModels& models, size_t plate, const absl::Status& status) {
  if (models.plates.size() == 1 || status.ok()) return status;
  const int of_project = models.plates[plate].number;
  const int number = of_project > 0 ? of_project : static_cast<int>(plate) + 1;
  return InFile(fmt::format("plate {}", number), status);
}

absl::Status CheckPlates(const GivenModels& models) {
  for (size_t i = 0; i < models.plates.size(); ++i)
    if (!models.plates[i].refused.ok()) return OfPlate(models, i, models.plates[i].refused);
  return absl::OkStatus();
}

absl::Status ErrorOfAll(const GivenModels& models) {
  const absl::Status& first = models.plates.front().refused;
  const bool alike = std::ranges::all_of(
      models.plates, [&](const GivenPlate& plate) { return plate.refused == first; });
  return alike ? first : absl::OkStatus();
}

std::vector<Setting> SettingsOf(const GivenPlate& plate, const std::vector<Setting>& given) {
  std::vector<Setting> settings = plate.settings;
  settings.insert(settings.end(), given.begin(), given.end());
  return settings;
}

absl::Status CheckOutputs(const JobOptions& options, const std::string& output) {
  if (absl::Status ok = config::CheckAllowed(options.allow); !ok.ok()) return ok;
  if (output != "-" && output == options.report && !output.empty())
    return Malformed(fmt::format("-o and --report name the same file: {}", output));
  if (!options.plates || (output != "-" && options.report != "-")) return absl::OkStatus();
  return Malformed("--plates makes several files, which cannot all go to stdout: use -o FILE");
}

absl::Status CheckWritable(const JobOptions& options, const std::string& output, size_t plate) {
  absl::Status may = CheckWritable(NamedOutput(options, output, "slicefarm.gcode", plate));
  return may.ok() ? CheckWritable(OutputOf(options, options.report, plate)) : may;
}

bool IsNamedBySettings(const std::string& output) {
  std::error_code error;
  return output.empty() || std::filesystem::is_directory(output, error);
}

std::string NamedOutput(const JobOptions& options, const std::string& output,
                        const std::string& file_name, size_t plate) {
  if (!IsNamedBySettings(output)) return OutputOf(options, output, plate);
  const std::filesystem::path folder =
      output.empty() ? std::filesystem::path(options.models.front()).parent_path()
                     : std::filesystem::path(output);
  return OutputOf(options, (folder / file_name).string(), plate);
}

absl::StatusOr<Project> ReadProject(const std::string& path, const MeshFile& file) {
  auto read = slicing::ReadMeshFile(file.bytes, file.format, limits::kMaxMeshCoordinateMm,
                                    slicing::ReadDepth::kStructure, {});
  if (!read.ok()) return InFile(path, read.status());
  return std::move(read->project);
}

}  // namespace slicefarm::cli
