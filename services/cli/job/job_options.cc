#include "services/cli/job/job_options.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <utility>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/config/missing_feature.h"
#include "common/config/process_settings.h"
#include "common/config/projects/ini.h"
#include "common/config/reported_settings.h"
#include "common/model/limits.h"
#include "common/rpc/utf8.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/files.h"
#include "services/cli/job/field_files.h"
#include "services/cli/job/output_name.h"

namespace slicefarm::cli {
namespace {

/// Checks that a setting is UTF-8, because settings are sent and reported as UTF-8.
absl::Status CheckText(const config::Setting& setting) {
  if (rpc::IsUtf8(setting.key) && rpc::IsUtf8(setting.value)) return absl::OkStatus();
  const std::string key = rpc::ToUtf8(setting.key, limits::kMaxNameBytes);
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{} is not UTF-8 text", key), {{"setting", key}});
}

}  // namespace

void AddPresetOptions(CLI::App& app, PresetOptions& options) {
  CLI::Option* sources = AddPresetSources(app, options.sources);
  CLI::Option* printer =
      app.add_option("--printer", options.printer,
                     "Printer preset for which the job is sliced; --config and --set override its "
                     "settings. In a project, settings that the designer changed are kept")
          ->type_name("NAME");
  sources->needs(printer);
  app.add_option(
         "--process", options.process,
         "Process preset (print settings): its name, or the part before @. Default: the preset "
         "that corresponds to the project's process, otherwise the default of the printer preset")
      ->needs(printer)
      ->type_name("NAME");
  app.add_option(
         "--filament", options.filament,
         "Filament preset: its name, or the part before @. Default: the preset that corresponds to "
         "the project's filament, otherwise the default of the printer preset")
      ->needs(printer)
      ->type_name("NAME");
}

void AddSettingOptions(CLI::App& app, SettingOptions& options) {
  app.add_option("-c,--config", options.config_files,
                 "File with settings: a config.ini of PrusaSlicer, or a G-code file with settings "
                 "at its end. May be repeated: later files override earlier ones")
      ->type_name("FILE.ini")
      ->allow_extra_args(false);
  app.add_option("-s,--set", options.sets,
                 "Setting that overrides the same setting in --config; may be repeated. `slicefarm "
                 "settings` lists all settings")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

bool UsesFarmPresets(const PresetOptions& options) {
  return options.sources.empty() && !options.printer.empty();
}

CLI::Option* AddPresetSources(CLI::App& app, std::vector<std::string>& sources) {
  return app
      .add_option("--presets", sources,
                  "Folder or file of presets of OrcaSlicer, Bambu Studio, PrusaSlicer or "
                  "SuperSlicer: its profiles, its data folder, an export (.json, .orca_printer, "
                  ".orca_filament, .bbscfg, .bbsflmt) or a bundle (.ini). May be repeated")
      ->type_name("DIR|FILE")
      ->allow_extra_args(false);
}

void AddMachineOption(CLI::App& app, Process& process) {
  std::map<std::string, Process> names;
  std::string words = "Manufacturing process of the job:";
  for (const ProcessInfo& info : kProcesses) {
    names[std::string(info.name)] = info.process;
    words += fmt::format(" {}{}: {}.", info.name,
                         info.process == kDefaultProcess ? " (the default)" : "", info.doc);
  }
  app.add_option("--machine", process, words)
      ->transform(OneOf(std::move(names)))
      ->type_name("MACHINE");
}

void AddJobOptions(CLI::App& app, JobOptions& options) {
  app.add_option("MODEL", options.models,
                 "Model: STL (binary or ASCII), OBJ, PLY or 3MF project. Several models are "
                 "printed together on a plate. -: a model from stdin")
      ->required();
  AddSettingOptions(app, options);
  AddPresetOptions(app, options.presets);
  AddMachineOption(app, options.process);
  auto* plate = app.add_option("--plate", options.plate,
                               "Plate to slice of a project with several plates, counted from 1")
                    ->check(InRange(1, static_cast<int>(limits::kMaxProjectPlates)))
                    ->type_name("N");
  app.add_flag("--plates", options.plates,
               "Make a job for each plate of a project, or for as many beds as all parts and "
               "copies need. -o OUT.gcode writes OUT-1.gcode, OUT-2.gcode and so on. `slice` "
               "writes all plates that can be made, and ends with the error of the first plate "
               "that fails. `submit` makes jobs of all plates, or of none if one is refused")
      ->excludes(plate);
  app.add_option("--copies", options.copies,
                 "Number of copies of a model, or of an object of a project; default: 1, or the "
                 "number in the project. May be repeated")
      ->type_name("MODEL=N")
      ->allow_extra_args(false);
  app.add_option(
         "--object-set", options.object_sets,
         "Setting that applies only to one model, or to one object of a project; may be repeated")
      ->type_name("MODEL:KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--units", options.units, "Length unit of the model's coordinates")
      ->check(OneOf(std::vector<std::string>{"mm", "cm", "m", "inch"}))
      ->capture_default_str();
  app.add_option("--scale", options.scale, "Scale factor, or one factor for each axis")
      ->type_name("S|X,Y,Z");
  auto* rotate_z =
      app.add_option(
             "--rotate-z", options.rotate_z_deg,
             "Rotation about the vertical axis, in degrees, counter-clockwise seen from above")
          ->type_name("DEG");
  app.add_option("--rotate", options.rotate, "Rotation about x, then y, then z, in degrees")
      ->type_name("X,Y,Z")
      ->excludes(rotate_z);
  auto* center =
      app.add_option("--center", options.centers,
                     "Position of the part's centre on the bed, in mm. May be repeated: a copy is "
                     "printed at each position. Without --center, a single part is placed in the "
                     "middle of the bed, and several parts or copies are arranged")
          ->type_name("X,Y")
          ->allow_extra_args(false);
  app.add_flag("--arrange", options.arrange,
               "Arrange all parts and copies on the bed, including the objects of a project, which "
               "otherwise keep their positions")
      ->excludes(center);
  app.add_option(
         "--density-field", options.fields.density,
         "File with the density of the sparse infill by position, which replaces fill_density")
      ->type_name("FIELD.json");
  app.add_option("--stress-field", options.fields.stress,
                 "File with the stresses in the part by position; the lines of the sparse infill "
                 "follow the directions of the principal stresses")
      ->type_name("FIELD.json");
  app.add_option("--materials", options.fields.materials,
                 "File with the mixing ratio of the materials of a mixing extruder, by position on "
                 "the plate")
      ->type_name("FIELD.json");
  app.add_option("--texture", options.texture.texture,
                 "Texture for --machine engrave: a flat solid (STL, OBJ, PLY), a height image "
                 "(PNG), or a computed texture as KIND:KEY=VALUE,...")
      ->type_name("TEXTURE");
  app.add_option(
         "--mask", options.texture.mask,
         "Mask image (PNG) that covers the flattened surface: only bright areas are engraved")
      ->type_name("MASK.png");
  app.add_option("--anchor", options.texture.anchor,
                 "Point on the surface where the texture's origin is placed, in mm")
      ->type_name("X,Y,Z");
  app.add_option(
         "--format", options.format,
         "Format of the output, regardless of its name and the settings: gcode, bgcode or "
         "gcode.3mf. With another --machine: cli, nc, ngc, svg, dxf, csv, stl, obj, png or map.png")
      ->type_name("FORMAT");
  std::string features;
  for (const config::Allowance& each : config::Allowances())
    features += fmt::format("{} {}: {}", features.empty() ? "" : ";", each.name, each.doc);
  app.add_option("--allow", options.allow,
                 "Features that the job may lose; without this option a job that would lose a "
                 "feature is refused." +
                     features)
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->allow_extra_args(false);
  AddGenericOption(app, options.generic);
  app.add_option("--report", options.report,
                 "File for a report of the result, as JSON; -: to stdout")
      ->type_name("REPORT.json");
  app.add_flag("-q,--quiet", options.quiet,
               "Print only warnings and errors, no progress and no summary");
}

void AddGenericOption(CLI::App& app, bool& generic) {
  app.add_flag("--generic", generic,
               "Allow a job for no particular printer: bed_shape, nozzle_diameter and gcode_flavor "
               "may have their default values");
}

bool ResultIsOnStdout(const JobOptions& options, const std::string& output) {
  return output == "-" || options.report == "-";
}

absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text) {
  const size_t equals = text.find('=');
  const std::string key(Trim(std::string_view(text).substr(0, equals)));
  if (equals == std::string::npos || key.empty()) {
    return Malformed(fmt::format("{} {}: KEY=VALUE is needed", option, text));
  }
  config::Setting setting{key, text.substr(equals + 1), config::Source::kRequest};
  if (absl::Status ok = CheckText(setting); !ok.ok()) return ok;
  return setting;
}

absl::Status Malformed(const std::string& message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

absl::StatusOr<std::vector<config::Setting>> GivenSettings(const SettingOptions& options) {
  std::vector<config::Setting> settings;
  for (const std::string& path : options.config_files) {
    const auto text = ReadText(path, kMaxConfigBytes);
    if (!text.ok()) return text.status();
    auto read = config::ReadIni(*text);
    if (!read.ok()) return InFile(path, read.status());
    settings.insert(settings.end(), read->begin(), read->end());
  }
  for (const std::string& text : options.sets) {
    auto setting = ParseSet("--set", text);
    if (!setting.ok()) return setting.status();
    settings.push_back(*std::move(setting));
  }
  for (const config::Setting& setting : settings) {
    if (absl::Status ok = CheckText(setting); !ok.ok()) return ok;
  }
  return settings;
}

namespace {

/// Adds the format that belongs to the file's name, unless a format is set.
void AddFileFormat(const std::string& output, Process process,
                   std::vector<config::Setting>& settings) {
  for (const config::FileFormat& format : config::SettingsOf(process).FileFormats()) {
    const bool given =
        std::ranges::find(settings, format.key, &config::Setting::key) != settings.end();
    if (!given && format.chosen_by_name && output.ends_with(format.suffix))
      settings.push_back(
          {std::string(format.key), std::string(format.value), config::Source::kRequest});
  }
}

}  // namespace

std::vector<config::Setting> WithCreationTime(std::vector<config::Setting> settings, bool anyway) {
  const auto names_clock = [](const config::Setting& setting) {
    constexpr std::string_view kTime = "creation_time = now\n";
    const bool is_template =
        setting.key.ends_with("gcode") || setting.key == "output_filename_format";
    return is_template && !config::LinesNamedIn(setting.value, kTime).empty();
  };
  if (!anyway && std::ranges::none_of(settings, names_clock)) return settings;
  std::string now = absl::FormatTime("%Y-%m-%dT%H:%M:%SZ", absl::Now(), absl::UTCTimeZone());
  settings.insert(settings.begin(), {"creation_time", std::move(now), config::Source::kProfile});
  return settings;
}

absl::StatusOr<std::vector<config::Setting>> GivenJobSettings(const JobOptions& options,
                                                              const std::string& output) {
  if (absl::Status named = CheckEnding(output, options.process);
      options.format.empty() && !named.ok())
    return named;
  auto settings = GivenSettings(options);
  if (!settings.ok()) return settings.status();
  const FieldOptions& fields = options.fields;
  for (const auto& [path, kind] : {std::pair(&fields.density, FieldKind::kDensity),
                                   std::pair(&fields.stress, FieldKind::kStress),
                                   std::pair(&fields.materials, FieldKind::kMaterials)}) {
    if (path->empty()) continue;
    auto setting = ReadFieldFile(*path, kind);
    if (!setting.ok()) return setting.status();
    settings->push_back(*std::move(setting));
  }
  if (options.format.empty()) {
    AddFileFormat(output, options.process, *settings);
    return settings;
  }
  auto format = FormatSettings(options.format, options.process);
  if (!format.ok()) return format.status();
  std::ranges::move(*format, std::back_inserter(*settings));
  return settings;
}

}  // namespace slicefarm::cli
