#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/scene.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

/// What one job prints.
struct GivenPlate {
  int number = 0;  ///< in the project, from 1; 0: what is no plate of a project
  absl::Status refused = {};  ///< why it cannot be made; else it has objects
  std::vector<SceneObject> objects = {};
  std::vector<Setting> settings = {};            ///< of projects; those given by hand win
  std::vector<std::string> without_effect = {};  ///< what projects have besides
  std::vector<std::string> warnings = {};        ///< of projects, to be shown
  std::vector<config::MissingFeature> missing = {};  ///< that projects ask for
};

/// The files of the models, and the objects that are made of them. A model that is named twice is
/// one file.
struct GivenModels {
  std::vector<MeshFile> files;
  std::vector<GivenPlate> plates;  ///< one, unless --plates asks for all of a project
};

/// Reads the models. The object of a file with one mesh is named for the file without its folders,
/// as UTF-8 without control characters; a project's objects, parts, copies and settings are those
/// of the plate that is chosen.
///
/// Errors: REQUEST_MALFORMED naming the option or the file, also for options that would move what a
/// project has placed; MESH_TOO_LARGE; those of reading a project and of config::JobOfProject. With
/// --plates, a plate without anything to print is refused, and the others are there.
absl::StatusOr<GivenModels> ReadModels(const JobOptions& options);

/// With --plates: each plate as many as it takes beds to put its copies on. `given`: the job's
/// settings, which have the bed. Refuses plates with the errors of config::ResolvePlate and of
/// arranging.
void PutOnBeds(const JobOptions& options, const std::vector<Setting>& given, GivenModels& models);

/// The error of the plate with this index, which it names where there are several.
absl::Status OfPlate(const GivenModels& models, size_t plate, const absl::Status& status);

/// That of the first plate that is refused.
absl::Status CheckPlates(const GivenModels& models);

/// The error that all plates are refused for alike, as for a setting that is unknown; else OK.
absl::Status ErrorOfAll(const GivenModels& models);

/// The settings of a plate's projects, then those given by hand.
std::vector<Setting> SettingsOf(const GivenPlate& plate, const std::vector<Setting>& given);

/// Errors: REQUEST_MALFORMED for --plates to stdout, for a result and a report of one name, and
/// those of config::CheckAllowed.
absl::Status CheckOutputs(const JobOptions& options, const std::string& output);

/// Whether the results of a plate can be written where OutputOf says, as CheckWritable.
absl::Status CheckWritable(const JobOptions& options, const std::string& output, size_t plate);

/// Where the result of the plate with this index goes: `out-2.gcode` for index 1 with --plates,
/// else as it was given. Nothing stays nothing.
std::string OutputOf(const JobOptions& options, const std::string& path, size_t plate);

/// Where the result goes if it is called `file_name` by its settings: there if `output` is a
/// folder, beside the first model if it is empty, else where `output` says. Then as OutputOf.
std::string NamedOutput(const JobOptions& options, const std::string& output,
                        const std::string& file_name, size_t plate);

/// Whether results are to be called as their settings say: `output` is a folder, or empty.
bool IsNamedBySettings(const std::string& output);

/// What a model file says besides its triangles. Errors: those of slicing::ReadMeshFile, naming the
/// file.
absl::StatusOr<Project> ReadProject(const std::string& path, const MeshFile& file);

}  // namespace slicefarm::cli
