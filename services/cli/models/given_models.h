#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// Content of one job.
struct GivenPlate {
  int number = 0;             ///< number in the project, from 1; 0: no plate of a project
  absl::Status refused = {};  ///< error if the plate cannot be made; otherwise it has objects
  std::vector<SceneObject> objects = {};
  /// Settings of projects, then of presets; settings given by hand override them.
  std::vector<Setting> settings = {};
  /// Other properties of projects, which have no effect.
  std::vector<std::string> without_effect = {};
  std::vector<std::string> warnings = {};            ///< warnings about projects, to be printed
  std::vector<config::MissingFeature> missing = {};  ///< features that projects require
};

/// Files of the models, and the objects in them. A model that is named twice is one file.
struct GivenModels {
  std::vector<MeshFile> files;
  std::vector<GivenPlate> plates;  ///< one plate, or all plates of a project with --plates
};

/// Reads the models. The object of a file with one mesh is named after the file without its
/// folders, as UTF-8 without control characters. The objects, parts, copies and settings of a
/// project are taken from the chosen plate. Settings of presets follow the project's.
///
/// Errors: REQUEST_MALFORMED naming the option or the file, also for options that would move placed
/// objects of a project; MESH_TOO_LARGE; errors of reading a project, of config::JobOfProject and of
/// TakePresets. With --plates, a plate without anything to print is refused, and the remaining
/// plates are returned.
absl::StatusOr<GivenModels> ReadModels(const JobOptions& options);

/// Distributes the copies of each plate over as many beds as needed, with --plates. `given`: the
/// job's settings, which define the bed. Refuses plates with the errors of config::ResolvePlate and
/// of arranging.
void PutOnBeds(const JobOptions& options, const std::vector<Setting>& given, GivenModels& models);

/// Returns the error with the name of this plate, if there are several plates.
absl::Status OfPlate(const GivenModels& models, size_t plate, const absl::Status& status);

/// Returns the error of the first refused plate, or OK.
absl::Status CheckPlates(const GivenModels& models);

/// Returns the error that all plates have in common, for example an unknown setting; otherwise OK.
absl::Status ErrorOfAll(const GivenModels& models);

/// Returns the settings of a plate's projects, then the given settings.
std::vector<Setting> SettingsOf(const GivenPlate& plate, const std::vector<Setting>& given);

/// Checks the outputs. Errors: REQUEST_MALFORMED for --plates to stdout, or for a result and a
/// report with the same name; as config::CheckAllowed.
absl::Status CheckOutputs(const JobOptions& options, const std::string& output);

/// Checks that the results of a plate can be written to the names of OutputOf, as CheckWritable.
absl::Status CheckWritable(const JobOptions& options, const std::string& output, size_t plate);

/// Returns the file for the result of the plate with this index. With --plates it is `out-2.gcode`
/// for index 1, otherwise `path`. An empty path stays empty.
std::string OutputOf(const JobOptions& options, const std::string& path, size_t plate);

/// Returns the file for a result that is called `file_name` by its settings. If `output` is a
/// folder, the file is in it. If `output` is empty, the file is beside the first model. Otherwise
/// the file is `output`. The number of the plate is added as by OutputOf.
std::string NamedOutput(const JobOptions& options, const std::string& output,
                        const std::string& file_name, size_t plate);

/// Returns true if results get their names from the settings: `output` is a folder, or empty.
bool IsNamedBySettings(const std::string& output);

/// Reads the data of a model file besides its triangles. Errors: as slicing::ReadMeshFile, naming
/// the file.
absl::StatusOr<Project> ReadProject(const std::string& path, const MeshFile& file);

}  // namespace slicefarm::cli
