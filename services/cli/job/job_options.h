#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace CLI {
class App;
}

namespace slicefarm::cli {

/// Settings as written on the command line.
struct SettingOptions {
  std::vector<std::string> config_files;
  std::vector<std::string> sets;  ///< key=value
};

/// Files of fields (common/model/fields/README.md); empty: none.
struct FieldOptions {
  std::string density;
  std::string stress;
  std::string materials;
};

/// Of engraving; empty: not given.
struct TextureArguments {
  std::string texture = {};  ///< a file, or a computed texture
  std::string mask = {};
  std::string anchor = {};
  std::string orient = {};
};

/// What `slice` and `submit` are told about the job, as written on the command line.
struct JobOptions : SettingOptions {
  std::vector<std::string> models;
  Process process = kDefaultProcess;
  std::vector<std::string> copies;       ///< MODEL=N
  std::vector<std::string> object_sets;  ///< MODEL:key=value
  std::string units = "mm";
  std::string scale;  ///< S, or X,Y,Z
  double rotate_z_deg = 0;
  std::string rotate;                ///< X,Y,Z
  std::vector<std::string> centers;  ///< X,Y
  bool arrange = false;              ///< what has a place, too
  int plate = 0;                     ///< of a project, from 1; 0: the only one
  bool plates = false;               ///< a job for each plate
  FieldOptions fields;
  TextureArguments texture;
  std::string format;              ///< of the output; empty: as its name or the settings say
  std::vector<std::string> allow;  ///< features that may be missing (config::Allowances)
  bool generic = false;            ///< for no particular printer
  std::string report;
  bool quiet = false;
};

void AddSettingOptions(CLI::App& app, SettingOptions& options);
void AddJobOptions(CLI::App& app, JobOptions& options);

/// `--machine NAME`: whose settings and results.
void AddMachineOption(CLI::App& app, Process& process);

/// The settings of the files, in their order, then those set by hand. Errors: REQUEST_MALFORMED for
/// a file that cannot be read and for a --set without `=`; those of ReadIni, with the file's name;
/// SETTING_MALFORMED for text that is not UTF-8.
absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options);

/// With the time of now as `creation_time`, which all others win over, if G-code or the file's name
/// among them may name it, or `anyway`.
std::vector<config::Setting> WithCreationTime(std::vector<config::Setting> settings,
                                              bool anyway = false);

/// All of them: those, the fields, and what the name of `output` stands for (config::FileFormat),
/// unless it is set or --format says it. Errors: those of ReadFieldFile, CheckEnding and
/// FormatSetting too.
absl::StatusOr<std::vector<config::Setting>> GivenJobSettings(const JobOptions& options,
                                                              const std::string& output);

/// REQUEST_MALFORMED: what the command line asks for cannot be had.
absl::Status Malformed(const std::string& message);

/// `KEY=VALUE` as a setting that was asked for. `option`: for errors, as GivenSettings' are.
absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text);

}  // namespace slicefarm::cli
