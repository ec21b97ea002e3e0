#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/model/process.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace slicefarm::cli {

/// Settings as written on the command line.
struct SettingOptions {
  std::vector<std::string> config_files;
  std::vector<std::string> sets;  ///< in the form key=value
};

/// Presets of a job by name, as written on the command line.
struct PresetOptions {
  std::vector<std::string> sources;  ///< folders and files of presets; empty: no presets are used
  std::string printer;
  std::string process;   ///< empty: the printer's default
  std::string filament;  ///< empty: the printer's default
};

/// Files of fields (common/model/fields/README.md); empty: none.
struct FieldOptions {
  std::string density;
  std::string stress;
  std::string materials;
};

/// Options for engraving; empty: not given.
struct TextureArguments {
  std::string texture = {};  ///< a file, or a computed texture
  std::string mask = {};
  std::string anchor = {};
  std::string orient = {};
};

/// Job options of `slice` and `submit`, as written on the command line.
struct JobOptions : SettingOptions {
  std::vector<std::string> models;
  Process process = kDefaultProcess;
  std::vector<std::string> copies;       ///< in the form MODEL=N
  std::vector<std::string> object_sets;  ///< in the form MODEL:key=value
  std::string units = "mm";
  std::string scale;  ///< in the form S, or X,Y,Z
  double rotate_z_deg = 0;
  std::string rotate;                ///< in the form X,Y,Z
  std::vector<std::string> centers;  ///< in the form X,Y
  bool arrange = false;              ///< arranges copies that already have a position too
  int plate = 0;                     ///< plate of a project, from 1; 0: the only one
  bool plates = false;               ///< makes a job for each plate
  PresetOptions presets;
  FieldOptions fields;
  TextureArguments texture;
  std::string format;              ///< output format; empty: from the output's name or the settings
  std::vector<std::string> allow;  ///< features that may be missing (config::Allowances)
  bool generic = false;            ///< the job is for no particular printer
  std::string report;
  bool quiet = false;
};

/// Add the options to a command.
void AddSettingOptions(CLI::App& app, SettingOptions& options);
void AddJobOptions(CLI::App& app, JobOptions& options);

/// Adds `--presets`, which may be repeated, and returns it.
CLI::Option* AddPresetSources(CLI::App& app, std::vector<std::string>& sources);

/// Adds `--machine NAME`, which selects the process: its settings and results.
void AddMachineOption(CLI::App& app, Process& process);

/// Returns the settings of the files, in their order, then the --set settings. Errors:
/// REQUEST_MALFORMED for a file that cannot be read and for a --set without `=`; as ReadIni, with
/// the file's name; SETTING_MALFORMED for text that is not UTF-8.
absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options);

/// Adds the current time as `creation_time` with the lowest priority, if a template in the settings
/// may use it, or with `anyway`. Templates are G-code and the file's name.
std::vector<config::Setting> WithCreationTime(std::vector<config::Setting> settings,
                                              bool anyway = false);

/// Returns all settings of a job: GivenSettings, the fields, and the format. The format is the one
/// of --format, or else the one that is set, or else the one of the name of `output`
/// (config::FileFormat). Errors: also as ReadFieldFile, CheckEnding and FormatSetting.
absl::StatusOr<std::vector<config::Setting>> GivenJobSettings(const JobOptions& options,
                                                              const std::string& output);

/// Returns REQUEST_MALFORMED for a command line that cannot be executed.
absl::Status Malformed(const std::string& message);

/// Parses `KEY=VALUE` as a setting of the request. `option`: name for errors. Errors: as
/// GivenSettings.
absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text);

}  // namespace slicefarm::cli
