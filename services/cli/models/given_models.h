#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/mesh.h"
#include "common/model/scene.h"
#include "services/cli/job_options.h"

namespace slicefarm::cli {

/// The files of the models, and the objects that are made of them. A model that is named twice is
/// one file.
struct GivenModels {
  std::vector<MeshFile> files;
  std::vector<SceneObject> objects;
  std::vector<Setting> settings;            ///< of projects; those given by hand win
  std::vector<std::string> without_effect;  ///< what projects have besides
};

/// Reads the models. The object of a file with one mesh is named for the file without its folders,
/// as UTF-8 without control characters; a project's objects, parts, copies and settings are those
/// of the plate that is chosen.
///
/// Errors: REQUEST_MALFORMED naming the option or the file, also for options that would move what a
/// project has placed; MESH_TOO_LARGE; those of reading a project and of config::JobOfProject.
absl::StatusOr<GivenModels> ReadModels(const JobOptions& options);

/// The bytes of a model file. Errors: REQUEST_MALFORMED naming the file; MESH_TOO_LARGE.
absl::StatusOr<MeshFile> ReadModelFile(const std::string& path);

/// What a model file says besides its triangles. Errors: those of slicing::ReadMeshFile, naming the
/// file.
absl::StatusOr<Project> ReadProject(const std::string& path, const MeshFile& file);

}  // namespace slicefarm::cli
