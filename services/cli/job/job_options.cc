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
#include "common/config/told_settings.h"
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
                   fmt::format("{}: is not UTF-8 text", key), {{"setting", key}});
}

}  // namespace

void AddSettingOptions(CLI::App& app, SettingOptions& options) {
  app.add_option("-c,--config", options.config_files,
                 "PrusaSlicer config.ini, or a G-code file that quotes its settings; of several, "
                 "later ones win")
      ->type_name("FILE.ini")
      ->allow_extra_args(false);
  app.add_option("-s,--set", options.sets, "One setting; wins over --config. May be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void AddMachineOption(CLI::App& app, Process& process) {
  std::map<std::string, Process> names;
  std::string words = "What the job is for:";
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
  app.add_option(
         "MODEL", options.models,
         "STL (binary or ASCII), OBJ or PLY file, or 3MF project; several: a plate of them; "
         "-: from stdin")
      ->required();
  AddSettingOptions(app, options);
  AddMachineOption(app, options.process);
  auto* plate =
      app.add_option("--plate", options.plate, "Which plate of a project with several, from 1")
          ->check(InRange(1, static_cast<int>(limits::kMaxProjectPlates)))
          ->type_name("N");
  app.add_flag(
         "--plates", options.plates,
         "A job for each plate of a project, or for as many beds as all parts and copies take; "
         "-o OUT.gcode gives OUT-1.gcode, OUT-2.gcode, ... `slice` makes those that can be made, "
         "and "
         "ends with the error of the first that cannot; `submit` makes all or none")
      ->excludes(plate);
  app.add_option("--copies", options.copies,
                 "How often a model, or an object of a project, is printed; may be repeated")
      ->type_name("MODEL=N")
      ->allow_extra_args(false);
  app.add_option("--object-set", options.object_sets,
                 "A setting of one model, or of an object of a project, alone; may be repeated")
      ->type_name("MODEL:KEY=VALUE")
      ->allow_extra_args(false);
  app.add_option("--units", options.units, "What a unit of the model means")
      ->check(OneOf(std::vector<std::string>{"mm", "cm", "m", "inch"}))
      ->capture_default_str();
  app.add_option("--scale", options.scale, "Factor, or one for each axis")->type_name("S|X,Y,Z");
  auto* rotate_z = app.add_option("--rotate-z", options.rotate_z_deg,
                                  "Turn about the vertical, counter-clockwise")
                       ->type_name("DEG");
  app.add_option("--rotate", options.rotate, "Turn about x, then y, then z")
      ->type_name("X,Y,Z")
      ->excludes(rotate_z);
  auto* center = app.add_option("--center", options.centers,
                                "Where the middle of the part lies, mm; repeated: a copy at each. "
                                "Default: the middle of the bed; several parts: arranged")
                     ->type_name("X,Y")
                     ->allow_extra_args(false);
  app.add_flag("--arrange", options.arrange,
               "Find places for all parts and copies, as without --center; for those of a project, "
               "too")
      ->excludes(center);
  app.add_option("--density-field", options.fields.density,
                 "How dense the sparse infill is, by place")
      ->type_name("FIELD.json");
  app.add_option("--stress-field", options.fields.stress,
                 "Stresses whose directions the sparse infill follows")
      ->type_name("FIELD.json");
  app.add_option("--materials", options.fields.materials,
                 "Shares of the materials of a mixing extruder, by place on the plate")
      ->type_name("FIELD.json");
  app.add_option("--texture", options.texture.texture,
                 "With --machine engrave: a planar solid (STL, OBJ, PLY), a height image (PNG), or "
                 "a computed texture, kind:key=value,...")
      ->type_name("TEXTURE");
  app.add_option("--mask", options.texture.mask,
                 "PNG over the surface's map: engraving works where it is bright")
      ->type_name("MASK.png");
  app.add_option("--anchor", options.texture.anchor,
                 "Where on the surface the texture's origin lies")
      ->type_name("X,Y,Z");
  app.add_option(
         "--format", options.format,
         "What the output is, whatever it is called and the settings say: gcode, bgcode; of "
         "other machines cli, nc, ngc, svg, dxf, csv, stl, obj, png, map.png")
      ->type_name("FORMAT");
  std::string features;
  for (const config::Allowance& each : config::Allowances())
    features += fmt::format("{} {}: {}", features.empty() ? "" : ";", each.name, each.doc);
  app.add_option("--allow", options.allow,
                 "What the job can do without; else it is refused, as its print would be spoilt." +
                     features)
      ->delimiter(',')
      ->type_name("NAME[,NAME...]")
      ->allow_extra_args(false);
  app.add_flag("--generic", options.generic,
               "The job is for no particular printer: no profile sets bed_shape, nozzle_diameter "
               "and gcode_flavor");
  app.add_option("--report", options.report, "Write what came out as JSON; -: to stdout")
      ->type_name("REPORT.json");
  app.add_flag("-q,--quiet", options.quiet, "No progress, no summary; warnings and errors only");
}

absl::StatusOr<config::Setting> ParseSet(std::string_view option, const std::string& text) {
  const size_t equals = text.find('=');
  const std::string key(Trim(std::string_view(text).substr(0, equals)));
  if (equals == std::string::npos || key.empty()) {
    return Malformed(fmt::format("{} {}: key=value is needed", option, text));
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
  auto format = FormatSetting(options.format, options.process);
  if (!format.ok()) return format.status();
  settings->push_back(*std::move(format));
  return settings;
}

}  // namespace slicefarm::cli
