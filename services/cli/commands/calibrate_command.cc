#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "common/config/resolve.h"
#include "services/cli/calibration/calibration_plan.h"
#include "services/cli/commands/commands.h"
#include "services/cli/commands/slicing.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/models/preset_sources.h"

namespace slicefarm::cli {
namespace {

struct CalibrateOptions : SliceOptions {
  CalibrationKind kind = CalibrationKind::kTemperature;
  GivenLevels levels;
  bool fine = false;
};

/// Values of the second pass of flow: below the best plate of the first pass, in steps of 1 %.
constexpr double kFineStart = -9, kFineEnd = 0, kFineStep = 1;

GivenLevels LevelsGiven(const CalibrateOptions& options) {
  GivenLevels levels = options.levels;
  if (!options.fine) return levels;
  levels.start = levels.start.value_or(kFineStart);
  levels.end = levels.end.value_or(kFineEnd);
  levels.step = levels.step.value_or(kFineStep);
  return levels;
}

/// Returns the effective settings before the calibration changes them.
absl::StatusOr<std::string> SettingsBefore(const GivenPlate& plate,
                                           const std::vector<Setting>& given, Process process) {
  const auto resolved = config::Resolve(WithCreationTime(SettingsOf(plate, given)), process);
  if (!resolved.ok()) return resolved.status();
  return resolved->effective_text;
}

/// Adds the objects of the print to the files and to the plate.
void AddParts(std::vector<CalibrationPart> parts, GivenModels& models) {
  for (CalibrationPart& part : parts) {
    SceneObject object =
        ObjectOfFile(part.name, static_cast<int32_t>(models.files.size()), Placement{}, 1);
    object.ranges = std::move(part.ranges);
    object.settings = std::move(part.settings);
    models.plates.front().objects.push_back(std::move(object));
    models.files.push_back({std::move(part.name), MeshFormat::kStl, std::move(part.stl)});
  }
}

void PrintTable(const CalibrateOptions& options, const std::vector<CalibrationRow>& rows) {
  if (options.job.quiet || options.output == "-" || options.job.report == "-") return;
  const CalibrationInfo& info = InfoOfCalibration(options.kind);
  for (const CalibrationRow& row : rows) {
    const std::string place =
        row.to_mm > 0 ? fmt::format("{:.1f} to {:.1f} mm", row.from_mm, row.to_mm) : row.object;
    const std::string setting =
        info.setting.empty() ? "" : fmt::format("  {} = {:g}", info.setting, row.value);
    Print(fmt::format("{:>8} {}  {}{}\n", row.label, info.unit, place, setting));
  }
}

ExitCode Calibrate(CalibrateOptions options, Interrupt& interrupt) {
  if (options.fine && options.kind != CalibrationKind::kFlow)
    return Fail(Malformed("--fine works only with flow"));
  if (UsesFarmPresets(options.job.presets))
    return Fail(Malformed("--printer: --presets DIR|FILE is needed, too"));
  if (absl::Status ok = CheckOutputs(options.job, options.output); !ok.ok()) return Fail(ok);
  if (absl::Status may = CheckWritable(options.job, options.output, 0); !may.ok()) return Fail(may);
  auto settings = GivenJobSettings(options.job, options.output);
  if (!settings.ok()) return Fail(settings.status());
  GivenModels models;
  models.plates.emplace_back();
  if (!options.job.presets.sources.empty()) {
    const auto set = ReadPresetSources(options.job.presets.sources);
    if (!set.ok()) return Fail(set.status());
    absl::Status taken = TakePresets(*set, options.job.presets, models.plates.front());
    if (!taken.ok()) return Fail(taken);
  }
  const auto before = SettingsBefore(models.plates.front(), *settings, options.job.process);
  if (!before.ok()) return Fail(before.status());
  const CalibrationInfo& info = InfoOfCalibration(options.kind);
  const bool relative = options.kind == CalibrationKind::kTemperature;
  const auto levels =
      LevelsOf(info, LevelsGiven(options), relative ? NumberIn(*before, "temperature", 0) : 0);
  if (!levels.ok()) return Fail(levels.status());
  auto plan = PlanCalibration(options.kind, *levels, *before);
  if (!plan.ok()) return Fail(plan.status());
  std::ranges::move(plan->settings, std::back_inserter(*settings));
  options.calibration_json = CalibrationJson(options.kind, plan->rows);
  AddParts(std::move(plan->parts), models);
  const ExitCode code = SlicePlates(options, std::move(models), *settings, interrupt);
  if (code == ExitCode::kOk) PrintTable(options, plan->rows);
  return code;
}

}  // namespace

void AddCalibrate(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "calibrate",
      "Make a print that shows the best value of a setting for a printer and filament");
  const auto options = std::make_shared<CalibrateOptions>();
  std::map<std::string, CalibrationKind> kinds;
  std::string words;
  for (const CalibrationInfo& info : CalibrationInfos()) {
    kinds[std::string(info.name)] = info.kind;
    words += fmt::format("\n  {:<17} {}", info.name, info.doc);
  }
  options->job.models = {"calibration"};
  command->add_option("KIND", options->kind, "Kind of the print; see below")
      ->required()
      ->transform(OneOf(std::move(kinds)))
      ->type_name("KIND");
  command->add_option("-o,--output", options->output, "File for the G-code; -: to stdout")
      ->required()
      ->type_name("OUT.gcode");
  AddSettingOptions(*command, options->job);
  AddPresetOptions(*command, options->job.presets);
  command
      ->add_option("--start", options->levels.start, "Value at the bottom, or of the first plate")
      ->type_name("VALUE");
  command->add_option("--end", options->levels.end, "Value at the top, or of the last plate")
      ->type_name("VALUE");
  command->add_option("--step", options->levels.step, "Difference of neighbouring values, above 0")
      ->type_name("VALUE");
  command->add_flag("--fine", options->fine,
                    "Second pass of flow: from -9 % to 0 % in steps of 1 %, relative to the best "
                    "value of the first pass");
  command
      ->add_option("--format", options->job.format,
                   "Format of the output: gcode, bgcode, gcode.3mf")
      ->type_name("FORMAT");
  command
      ->add_option("--report", options->job.report,
                   "File for a report as JSON, with the table of values; -: to stdout")
      ->type_name("REPORT.json");
  command->add_flag("--generic", options->job.generic, "Allow a print for no particular printer");
  command->add_flag("-q,--quiet", options->job.quiet, "Print only warnings and errors");
  AddThreadsOption(*command, options->threads);
  command->footer(
      "Kinds:" + words +
      "\nThe values are raised on the print. Without --start, --end and --step, common values are "
      "used.\nExample:\n  slicefarm calibrate temperature -o tower.gcode --presets "
      "~/.config/OrcaSlicer --printer \"Prusa MK4 0.4 nozzle\"");
  command->callback([options, &context] {
    context.run = [options, &context] { return Calibrate(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
