#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/mesh.h"
#include "common/model/scene.h"

namespace slicefarm::cli {

/// Settings as written on the command line.
struct SettingOptions {
  std::vector<std::string> config_files;
  std::vector<std::string> sets;  ///< key=value
};

/// What `slice` and `submit` are told about the job, as written on the command line.
struct JobOptions : SettingOptions {
  std::vector<std::string> models;
  std::vector<std::string> copies;       ///< MODEL=N
  std::vector<std::string> object_sets;  ///< MODEL:key=value
  std::string units = "mm";
  std::string scale;  ///< S, or X,Y,Z
  double rotate_z_deg = 0;
  std::string rotate;                ///< X,Y,Z
  std::vector<std::string> centers;  ///< X,Y
  std::string report;
  bool quiet = false;
};

void AddSettingOptions(CLI::App& app, SettingOptions& options);
void AddJobOptions(CLI::App& app, JobOptions& options);

/// The settings of the files, in their order, then those set by hand. Errors: REQUEST_MALFORMED for
/// a file that cannot be read and for a --set without `=`; those of ReadIni, with the file's name;
/// SETTING_MALFORMED for text that is not UTF-8.
absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options);

struct GivenObject {
  std::string name;
  int32_t file = 0;
  Placement placement;
  int32_t copies = 0;  ///< 0: one, or one at each of the placement's centers
  std::vector<Setting> settings;
};

/// The files of the models, and the objects that are made of them. A model that is named twice is
/// one file.
struct GivenModels {
  std::vector<MeshFile> files;
  std::vector<GivenObject> objects;
};

/// Reads the models; an object is named for its file without folders, as UTF-8 without control
/// characters. Errors: REQUEST_MALFORMED naming the option or the file; MESH_TOO_LARGE.
absl::StatusOr<GivenModels> ReadModels(const JobOptions& options);

std::vector<SceneObject> SceneOf(const GivenModels& given);

}  // namespace slicefarm::cli
