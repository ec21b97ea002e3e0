#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/preset_set.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"
#include "common/model/setting_source.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Content of one job.
struct GivenPlate {
  int number = 0;  ///< number of the plate in the project, from 1; 0: the plate is of no project
  /// Error if no job can be made from the plate; if OK, the plate has objects.
  absl::Status refused = {};
  std::vector<SceneObject> objects = {};
  /// Settings from project files. Settings on the command line override them.
  std::vector<Setting> settings = {};
  /// Full names of the presets from which `settings` are; empty: the settings are not from presets.
  config::presets::PresetNames presets = {};
  /// Sources of `settings`, if they are from presets.
  std::vector<SettingSource> sources = {};
  /// Other properties in project files, which have no effect.
  std::vector<std::string> without_effect = {};
  std::vector<std::string> warnings = {};  ///< warnings about project files, to be printed
  /// Features that project files require and slicefarm lacks.
  std::vector<config::MissingFeature> missing = {};
};

/// Files of the models, and their objects. If a model is given twice, its file is stored once.
struct GivenModels {
  std::vector<MeshFile> files;
  std::vector<GivenPlate> plates;  ///< one plate, or all plates of a project with --plates
};

/// Reads the models. The object of a file with one mesh is named after the file without its
/// folders, as UTF-8 without control characters. The objects, parts, copies and settings of a
/// project are taken from the chosen plate. With presets, the settings are theirs, with the changes
/// of the project's designer (config::presets::ForPrinter). `presets`: presets of the farm, or
/// nullptr; the options' own sources come first.
///
/// Errors: REQUEST_MALFORMED with the option or the file, also for options that would move placed
/// objects of a project; any error of ReadModelFile, ReadProject and config::JobOfProject. With
/// --plates, a plate without anything to print has an error in `refused`, and the other plates are
/// returned.
absl::StatusOr<GivenModels> ReadModels(const JobOptions& options,
                                       const config::presets::PresetSet* presets = nullptr);

/// Returns true if the name of a model ends like a 3MF project.
bool HasProject(const JobOptions& options);

/// Distributes the copies of each plate over as many beds as needed, if --plates is given. `given`:
/// the job's settings, which define the bed. If config::ResolvePlate or the arranging fails for a
/// plate, its error is stored in `refused`.
void PutOnBeds(const JobOptions& options, const std::vector<Setting>& given, GivenModels& models);

/// Returns the error with the name of this plate, if there are several plates.
absl::Status OfPlate(const GivenModels& models, size_t plate, const absl::Status& status);

/// Returns the error of the first refused plate, or OK.
absl::Status CheckPlates(const GivenModels& models);

/// Returns the error that all plates have in common, for example an unknown setting; otherwise OK.
absl::Status ErrorOfAll(const GivenModels& models);

/// Returns the settings of a plate's projects, then the given settings.
std::vector<Setting> SettingsOf(const GivenPlate& plate, const std::vector<Setting>& given);

/// Checks the output options. Errors: REQUEST_MALFORMED for --plates to stdout, or for a result and
/// a report with the same name; errors of config::CheckAllowed.
absl::Status CheckOutputs(const JobOptions& options, const std::string& output);

/// Checks that the result files of a plate (OutputOf) can be written. Errors: see CheckWritable in
/// files.h.
absl::Status CheckWritable(const JobOptions& options, const std::string& output, size_t plate);

/// Returns the output file of a result. `file_name`: its name according to the settings. If
/// `output` is a folder, the file is in this folder. If `output` is empty, the file is beside the
/// first model. Otherwise the file is `output`, and `file_name` is not used. With --plates, the
/// number of the plate is added as in OutputOf.
std::string NamedOutput(const JobOptions& options, const std::string& output,
                        const std::string& file_name, size_t plate);

/// Returns true if NamedOutput uses the name from the settings: `output` is a folder or empty.
bool IsNamedBySettings(const std::string& output);

/// Reads all data of a model file except its triangles. Errors: see slicing::ReadMeshFile, with the
/// file's name.
absl::StatusOr<Project> ReadProject(const std::string& path, const MeshFile& file);

}  // namespace slicefarm::cli
