#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/mesh.h"

namespace slicefarm::cli {

/// Settings as written on the command line.
struct SettingOptions {
  std::vector<std::string> config_files;
  std::vector<std::string> sets;  ///< key=value
};

/// What `slice` and `submit` are told about the job, as written on the command line.
struct JobOptions : SettingOptions {
  std::string model;
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

/// Errors: REQUEST_MALFORMED naming the option.
absl::StatusOr<Placement> GivenPlacement(const JobOptions& options);

/// The model's bytes; its name is the file's without folders, as UTF-8 without control
/// characters. Errors: REQUEST_MALFORMED,
/// MESH_TOO_LARGE.
absl::StatusOr<MeshFile> ReadModel(const JobOptions& options);

}  // namespace slicefarm::cli
