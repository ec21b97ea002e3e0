#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/config/resolve.h"
#include "services/cli/calibration/calibration_plan.h"
#include "services/cli/commands/commands.h"
#include "services/cli/commands/slicing.h"
#include "services/cli/commands/submitting.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/models/preset_sources.h"

namespace slicefarm::cli {
namespace {

struct CalibrateOptions : SubmitOptions {
  int threads = 0;
  bool on_farm = false;
  std::optional<CalibrationKind> kind;
  GivenLevels levels;
  bool fine = false;
  CalibrationMethod method = CalibrationMethod::kTower;
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

absl::Status CheckCalibrateOptions(const CalibrateOptions& options) {
  if (options.fine && options.kind != CalibrationKind::kFlow)
    return Malformed("--fine works only with the kind flow");
  if (options.method != CalibrationMethod::kTower &&
      options.kind != CalibrationKind::kPressureAdvance)
    return Malformed("--method works only with the kind pressure-advance");
  const bool of_farm = options.detach || options.json || !options.profiles.empty() ||
                       !options.job.presets.bundles.empty();
  if (!options.on_farm && of_farm)
    return Malformed("--detach, --json, --profile, --bundle: only for a farm; add --server");
  if (!options.on_farm && UsesFarmPresets(options.job.presets))
    return Malformed("--printer: add --presets DIR|FILE, or --server for the presets of a farm");
  if (absl::Status ok = CheckDetach(options); !ok.ok()) return ok;
  if (options.output.empty() && !options.detach)
    return Malformed("the output file is not named: use -o OUT.gcode");
  if (absl::Status ok = CheckOutputs(options.job, options.output); !ok.ok()) return ok;
  return options.detach ? absl::OkStatus() : CheckWritable(options.job, options.output, 0);
}

/// Returns a plate without objects, with the settings of presets that are read on this machine.
absl::StatusOr<GivenPlate> EmptyPlate(const CalibrateOptions& options) {
  GivenPlate plate;
  if (options.job.presets.sources.empty()) return plate;
  const auto set = ReadPresetSources(options.job.presets.sources);
  if (!set.ok()) return set.status();
  if (absl::Status taken = TakePresets(*set, options.job.presets, plate); !taken.ok()) return taken;
  return plate;
}

/// Returns the effective settings before the calibration changes them. `client`: the farm; nullptr:
/// this machine.
absl::StatusOr<std::string> SettingsBefore(const CalibrateOptions& options, const GivenPlate& plate,
                                           const std::vector<Setting>& given, JobsClient* client) {
  std::vector<Setting> all = SettingsOf(plate, given);
  if (client != nullptr) {
    auto on_farm = SettingsOnFarm(options, plate, given, *client);
    if (!on_farm.ok()) return on_farm.status();
    all = *std::move(on_farm);
  }
  const auto resolved = config::Resolve(WithCreationTime(std::move(all)), options.job.process);
  if (!resolved.ok()) return resolved.status();
  return resolved->effective_text;
}

/// Returns the print for the settings before.
absl::StatusOr<CalibrationPlan> PlanOf(const CalibrateOptions& options, std::string_view before) {
  const CalibrationInfo& info = InfoOfCalibration(*options.kind);
  const bool relative = options.kind == CalibrationKind::kTemperature;
  const auto levels =
      LevelsOf(info, LevelsGiven(options), relative ? NumberIn(before, "temperature", 0) : 0);
  if (!levels.ok()) return levels.status();
  return PlanCalibration(*options.kind, *levels, before, options.method);
}

/// Adds the objects of the print to the files and to the plate.
void AddParts(std::vector<CalibrationPart> parts, GivenModels& models) {
  for (CalibrationPart& part : parts) {
    Placement placement;
    if (part.middle) placement.centers = {*part.middle};
    SceneObject object =
        ObjectOfFile(part.name, static_cast<int32_t>(models.files.size()), placement, 1);
    object.ranges = std::move(part.ranges);
    object.settings = std::move(part.settings);
    models.plates.front().objects.push_back(std::move(object));
    models.files.push_back({std::move(part.name), MeshFormat::kStl, std::move(part.stl)});
  }
}

void PrintTable(const CalibrateOptions& options, const CalibrationTable& table) {
  if (options.job.quiet || options.json || ResultIsOnStdout(options.job, options.output)) return;
  for (const CalibrationRow& row : table.rows) {
    const std::string part =
        row.to_mm > 0 ? fmt::format("{:.1f} to {:.1f} mm", row.from_mm, row.to_mm) : row.object;
    const std::string setting =
        table.setting.empty() ? "" : fmt::format("  {} = {:g}", table.setting, row.value);
    Print(fmt::format("{:>8} {}  {}{}\n", row.label, table.unit, part, setting));
  }
}

ExitCode Make(CalibrateOptions options, GivenModels models, const std::vector<Setting>& settings,
              JobsClient* client, Interrupt& interrupt) {
  if (client != nullptr) return SubmitModels(options, models, settings, *client, interrupt);
  const SliceOptions here = {options.job, options.output, options.threads, options.calibration};
  return SlicePlates(here, std::move(models), settings, interrupt);
}

ExitCode Calibrate(CalibrateOptions options, Interrupt& interrupt) {
  if (absl::Status fits = CheckCalibrateOptions(options); !fits.ok()) return Fail(fits);
  auto settings = GivenJobSettings(options.job, options.output);
  if (!settings.ok()) return Fail(settings.status());
  auto plate = EmptyPlate(options);
  if (!plate.ok()) return Fail(plate.status());
  std::unique_ptr<JobsClient> client;
  if (options.on_farm) client = std::make_unique<JobsClient>(OptionsOfClient(options, interrupt));
  const auto before = SettingsBefore(options, *plate, *settings, client.get());
  if (!before.ok()) return Fail(before.status());
  auto plan = PlanOf(options, *before);
  if (!plan.ok()) return Fail(plan.status());
  std::ranges::move(plan->settings, std::back_inserter(*settings));
  options.calibration = std::move(plan->table);
  GivenModels models;
  models.plates.push_back(*std::move(plate));
  AddParts(std::move(plan->parts), models);
  const ExitCode code = Make(options, std::move(models), *settings, client.get(), interrupt);
  if (code == ExitCode::kOk && !options.detach) PrintTable(options, options.calibration);
  return code;
}

}  // namespace

void AddCalibrate(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("calibrate",
                                         "Write G-code of a test print that shows the best value "
                                         "of a setting for a printer and filament");
  const auto options = std::make_shared<CalibrateOptions>();
  std::map<std::string, CalibrationKind> kinds;
  std::string words;
  for (const CalibrationInfo& info : CalibrationInfos()) {
    kinds[std::string(info.name)] = info.kind;
    words += fmt::format("\n  {:<17} {}", info.name, info.doc);
  }
  options->job.models = {"calibration"};
  command
      ->add_option("KIND", options->kind,
                   "Kind of the test print, which is also the setting to find; see below")
      ->transform(OneOf(std::move(kinds)))
      ->type_name("KIND");
  command->add_option("-o,--output", options->output, "File for the G-code; -: to stdout")
      ->type_name("OUT.gcode");
  AddSettingOptions(*command, options->job);
  AddPresetOptions(*command, options->job.presets);
  command
      ->add_option("--start", options->levels.start,
                   "First value: at the bottom of a tower, or of the first plate")
      ->type_name("VALUE");
  command
      ->add_option("--end", options->levels.end,
                   "Last value: at the top of a tower, or of the last plate")
      ->type_name("VALUE");
  command
      ->add_option("--step", options->levels.step,
                   "Difference between neighbouring values, above 0")
      ->type_name("VALUE");
  command->add_flag("--fine", options->fine,
                    "Second pass of flow: from -9 % to 0 % in steps of 1 %, relative to the best "
                    "value of the first pass");
  command
      ->add_option(
          "--method", options->method,
          "Print of pressure-advance: a tower with corners; lines that change their speed; "
          "or a pattern of corners. The lines and the pattern are flat")
      ->transform(
          OneOf(std::map<std::string, CalibrationMethod>{{"tower", CalibrationMethod::kTower},
                                                         {"line", CalibrationMethod::kLine},
                                                         {"pattern", CalibrationMethod::kPattern}}))
      ->type_name("tower|line|pattern");
  command
      ->add_option("--format", options->job.format,
                   "Format of the output: gcode, bgcode, gcode.3mf")
      ->type_name("FORMAT");
  command
      ->add_option("--report", options->job.report,
                   "File for a report as JSON, with the table of values; -: to stdout")
      ->type_name("REPORT.json");
  AddGenericOption(*command, options->job.generic);
  command->add_flag("-q,--quiet", options->job.quiet, "Print only warnings and errors");
  AddThreadsOption(*command, options->threads);
  command->add_flag("--detach", options->detach,
                    "On a farm: print the job's id and do not wait for the job");
  command->add_flag("--json", options->json, "On a farm: print the job as one line of JSON");
  AddFarmSettingOptions(*command, *options);
  AddServerOptions(*command, options->server);
  AddApply(*command, context);
  command->footer(
      "Kinds:" + words +
      "\nThe values are raised on the print. Without --start, --end and --step, common values are "
      "used. With --server, or if SLICEFARM_SERVER is set, the print is a job of the farm; `apply` "
      "stores the value that is best.\nExamples:\n  slicefarm calibrate temperature -o tower.gcode "
      "--presets ~/.config/OrcaSlicer --printer \"Prusa MK4 0.4 nozzle\"\n  slicefarm calibrate "
      "pressure-advance -o pa.gcode --server farm:50050 --printer \"Prusa MK4 0.4 nozzle\"");
  command->callback([options, command, &context] {
    if (!command->get_subcommands().empty()) return;
    if (!options->kind) throw CLI::RequiredError("KIND");
    options->on_farm = command->get_option("--server")->count() > 0;
    context.run = [options, &context] { return Calibrate(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
