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
  std::vector<std::string> sets;  ///< settings in the form KEY=VALUE
};

/// Presets of a job by name, as written on the command line.
struct PresetOptions {
  std::vector<std::string> sources;  ///< folders and files of presets
  std::vector<std::string> bundles;  ///< bundles on the farm, if `sources` is empty; empty: all
  std::string printer;               ///< empty: no presets are used
  std::string process;               ///< empty: the printer's default
  std::string filament;              ///< empty: the printer's default
};

/// Files with fields of values in space (common/model/fields/README.md); empty: no field.
struct FieldOptions {
  std::string density;
  std::string stress;
  std::string materials;
};

/// Options for engraving; empty: not given.
struct TextureArguments {
  std::string texture = {};  ///< image file or name of a computed texture
  std::string mask = {};
  std::string anchor = {};
  std::string orient = {};
};

/// Job options of `slice` and `submit`, as written on the command line.
struct JobOptions : SettingOptions {
  std::vector<std::string> models;
  Process process = kDefaultProcess;
  std::vector<std::string> copies;       ///< numbers of copies, in the form MODEL=N
  std::vector<std::string> object_sets;  ///< settings of one model, in the form MODEL:KEY=VALUE
  std::string units = "mm";
  std::string scale;  ///< scale factors, in the form S, or X,Y,Z
  double rotate_z_deg = 0;
  std::string rotate;                ///< angles in degrees, in the form X,Y,Z
  std::vector<std::string> centers;  ///< positions on the bed in mm, in the form X,Y
  bool arrange = false;              ///< true: also arranges copies that already have a position
  int plate = 0;        ///< number of the plate of a project, from 1; 0: the project's only plate
  bool plates = false;  ///< true: makes one job for each plate of the project
  PresetOptions presets;
  FieldOptions fields;
  TextureArguments texture;
  std::string format;  ///< output format; empty: determined by the output's name or by the settings
  std::vector<std::string> allow;  ///< features that may be missing (config::Allowances)
  bool generic = false;            ///< true if the job is for no particular printer (--generic)
  std::string report;
  bool quiet = false;
};

/// Adds the options for settings to a command.
void AddSettingOptions(CLI::App& app, SettingOptions& options);
/// Adds all job options to a command.
void AddJobOptions(CLI::App& app, JobOptions& options);

/// Adds `--generic`, which allows a job for no particular printer.
void AddGenericOption(CLI::App& app, bool& generic);

/// Adds the options that choose presets by name.
void AddPresetOptions(CLI::App& app, PresetOptions& options);

/// Returns true if the job has presets that the farm stores.
bool UsesFarmPresets(const PresetOptions& options);

/// Adds `--presets`, which may be repeated, and returns it.
CLI::Option* AddPresetSources(CLI::App& app, std::vector<std::string>& sources);

/// Adds `--machine NAME`, which selects the process of the job and thereby its settings and
/// results.
void AddMachineOption(CLI::App& app, Process& process);

/// Returns the settings of the files, in the order of the files, followed by the --set settings.
/// Errors: REQUEST_MALFORMED for a file that cannot be read and for a --set without `=`;
/// SETTING_MALFORMED for text that is not UTF-8; errors of ReadIni, with the file's name.
absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options);

/// Adds the current time as `creation_time`, with the lowest priority, if a template in the
/// settings may use it. Templates are texts of G-code and of the output's name. `anyway`: adds the
/// time even if no template may use it.
std::vector<config::Setting> WithCreationTime(std::vector<config::Setting> settings,
                                              bool anyway = false);

/// Returns all settings of a job: GivenSettings, the fields, and the output format. The format is
/// the one of --format; without --format, the one in the settings; without both, the one that fits
/// the name of `output` (config::FileFormat). Errors: see GivenSettings, ReadFieldFile, CheckEnding
/// and FormatSettings.
absl::StatusOr<std::vector<config::Setting>> GivenJobSettings(const JobOptions& options,
                                                              const std::string& output);

/// Returns true if the output or the report of the job goes to stdout. Then the summary goes to
/// stderr.
bool ResultIsOnStdout(const JobOptions& options, const std::string& output);

/// Returns the error REQUEST_MALFORMED for a command line that cannot be executed.
absl::Status Malformed(const std::string& message);

/// Parses `KEY=VALUE` as a setting of the request. `option`: name of the option, for error
/// messages. Errors: as in GivenSettings.
absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text);

}  // namespace slicefarm::cli
