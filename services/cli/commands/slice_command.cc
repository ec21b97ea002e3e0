#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "common/base/build_info.h"
#include "common/base/sha256.h"
#include "common/config/machine_named.h"
#include "common/config/plate.h"
#include "common/config/presets/setting_sources.h"
#include "common/config/process_settings.h"
#include "common/config/table/settings_table.h"
#include "services/cli/commands/commands.h"
#include "services/cli/commands/slicing.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/cli/job/job_options.h"
#include "services/cli/job/joined_plates.h"
#include "services/cli/job/output_name.h"
#include "services/cli/job/summary.h"
#include "services/cli/local/local_pipeline.h"
#include "services/cli/models/given_models.h"
#include "services/cli/models/texture_argument.h"
#include "services/coordinator/algo/pipeline/report_json.h"

namespace slicefarm::cli {
namespace {

int ThreadsOf(const SliceOptions& options) {
  if (options.threads > 0) return options.threads;
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMaxThreads);
}

absl::StatusOr<config::ResolvedPlate> Resolve(const GivenPlate& given,
                                              const std::vector<Setting>& settings,
                                              Process process) {
  auto plate =
      config::ResolvePlate(WithCreationTime(SettingsOf(given, settings)), given.objects, process);
  if (!plate.ok()) return plate;
  config::PutInFront(given.without_effect, plate->no_effect);
  std::ranges::copy(given.warnings, std::back_inserter(plate->warnings));
  for (const config::MissingFeature& each : given.missing) {
    plate->missing.push_back(each);
    plate->warnings.push_back(each.text);
  }
  return plate;
}

coordinator::JobInput InputOf(std::vector<MeshFile> files, const config::ResolvedPlate& plate) {
  return {.meshes = {std::move(files), plate.objects},
          .settings = plate.settings,
          .settings_text = plate.effective_text,
          .warnings = plate.warnings};
}

config::ResultWords WordsOf(const SliceOptions& options) {
  return config::SettingsOf(options.job.process).Words();
}

absl::StatusOr<coordinator::JobOutput> Run(const SliceOptions& options, coordinator::JobInput input,
                                           Interrupt& interrupt) {
  const LocalPipeline local(ThreadsOf(options));
  const StageCall call = {
      .job_id = "local", .cancel = interrupt.Token(), .threads = ThreadsOf(options)};
  ProgressBar bar(!options.job.quiet);
  bar.Show("reading", 0, 0);
  const config::ResultWords words = WordsOf(options);
  return local.pipeline().Run(call, std::move(input), [&](coordinator::PipelineProgress progress) {
    bar.Show(words.many, progress.done, progress.total);
  });
}

absl::Status WriteResults(const SliceOptions& options, const coordinator::JobOutput& output,
                          const config::ResolvedPlate& resolved,
                          std::vector<SettingSource> sources) {
  if (!options.job.report.empty()) {
    const std::string json = coordinator::ReportJson(
        output.report, {.settings_without_effect = config::TextsOf(resolved.no_effect),
                        .settings_digest = Sha256Hex(resolved.effective_text),
                        .build_id = std::string(BuildId()),
                        .calibration = options.calibration,
                        .sources = std::move(sources)});
    if (absl::Status status = WriteFile(options.job.report, json); !status.ok()) return status;
  }
  return WriteFile(options.output, output.program);
}

/// Returns the settings without effect that change the print. The user gets a warning about them.
std::vector<std::string> ChangingPrint(const config::ResolvedPlate& plate) {
  std::vector<std::string> notes = config::TextsOf(plate.no_effect);
  std::erase_if(notes, [&](const std::string& note) {
    return std::ranges::find(plate.warnings, note) == plate.warnings.end();
  });
  return notes;
}

void PrintSummary(const SliceOptions& options, const coordinator::JobReport& report,
                  const config::ResolvedPlate& resolved) {
  WarnOfRest(report.warnings, resolved.warnings);
  if (options.job.quiet) return;
  Print(SummaryText({.output = options.output == "-" ? "" : options.output,
                     .words = WordsOf(options),
                     .layers = report.layer_count,
                     .print_time_s = report.print_time_s,
                     .filament_mm = report.filament.length_mm,
                     .filament_g = report.filament.mass_g,
                     .settings_without_effect = std::ssize(resolved.no_effect),
                     .changing = ChangingPrint(resolved),
                     .beside_print = resolved.beside_print,
                     .report = options.job.report}),
        ResultIsOnStdout(options.job, options.output));
}

/// Checks that all features missing for the plate are allowed, and that the output's name fits the
/// job's format.
absl::Status CheckPlate(const SliceOptions& options, const config::ResolvedPlate& plate) {
  absl::Status ok = config::CheckMissing(plate.missing, options.job.allow);
  if (!ok.ok() || !options.job.format.empty() || IsNamedBySettings(options.output)) return ok;
  return CheckFormat(options.output, options.job.process, plate.effective_text);
}

/// Returns the sources of all settings of a job with presets, for the report.
std::vector<SettingSource> SourcesOf(const GivenPlate& plate,
                                     const std::vector<Setting>& settings) {
  if (plate.sources.empty()) return {};
  std::vector<SettingSource> sources = plate.sources;
  SettingSource config = {"config", {}}, job = {"job", {}};
  for (const Setting& setting : settings)
    (setting.source == config::Source::kProfile ? config : job).keys.push_back(setting.key);
  sources.push_back(std::move(config));
  sources.push_back(std::move(job));
  return config::presets::LastSources(sources);
}

void WarnWithoutMachine(const std::vector<Setting>& settings, Process process) {
  const absl::Status named = config::CheckMachineNamed(settings, process);
  if (named.ok()) return;
  Warn({std::string(named.message()) + "; give the printer's profile with --config FILE, or add "
                                       "--generic if the job is for no particular printer"});
}

/// Slices one plate of `models` and writes its results. Moves the models' files into the job.
ExitCode SlicePlate(SliceOptions options, std::vector<MeshFile> files, const GivenModels& models,
                    const std::vector<Setting>& settings, size_t plate, Interrupt& interrupt) {
  const GivenPlate& given = models.plates[plate];
  const auto fail = [&](const absl::Status& why) { return Fail(OfPlate(models, plate, why)); };
  if (!given.refused.ok()) return fail(given.refused);
  const auto resolved = Resolve(given, settings, options.job.process);
  if (!resolved.ok()) Warn(given.warnings);
  if (!resolved.ok()) return fail(resolved.status());
  if (absl::Status ok = CheckPlate(options, *resolved); !ok.ok()) return fail(ok);
  if (!options.job.generic) WarnWithoutMachine(SettingsOf(given, settings), options.job.process);
  Warn(resolved->warnings);
  auto output = Run(options, InputOf(std::move(files), *resolved), interrupt);
  if (!output.ok()) {
    const bool mesh = ExitCodeOf(output.status()) == ExitCode::kBadMesh;
    const bool one = options.job.models.size() == 1;
    return fail(mesh && one ? InFile(options.job.models[0], output.status()) : output.status());
  }
  options.output = NamedOutput(options.job, options.output, output->report.file_name, plate);
  options.job.report = OutputOf(options.job, options.job.report, plate);
  if (absl::Status status = WriteResults(options, *output, *resolved, SourcesOf(given, settings));
      !status.ok()) {
    return Fail(status);
  }
  PrintSummary(options, output->report, *resolved);
  return ExitCode::kOk;
}

/// Returns true for an error of the plate itself, so that the next plate may succeed.
bool IsOfPlate(ExitCode code) {
  return code == ExitCode::kBadSettings || code == ExitCode::kBadMesh || code == ExitCode::kUsage;
}

}  // namespace

ExitCode SlicePlates(const SliceOptions& options, GivenModels models,
                     const std::vector<Setting>& settings, Interrupt& interrupt) {
  ExitCode first = ExitCode::kOk;
  const size_t plates = models.plates.size();
  for (size_t i = 0; i < plates; ++i) {
    const bool last = i + 1 == plates;
    std::vector<MeshFile> files = last ? std::move(models.files) : models.files;
    const ExitCode code = SlicePlate(options, std::move(files), models, settings, i, interrupt);
    if (first == ExitCode::kOk) first = code;
    if (code != ExitCode::kOk && !IsOfPlate(code)) return code;
  }
  if (first != ExitCode::kOk) return first;
  const absl::Status joined = JoinPlates(options.job, options.output, plates);
  return joined.ok() ? ExitCode::kOk : Fail(joined);
}

namespace {

ExitCode Slice(SliceOptions options, Interrupt& interrupt) {
  if (absl::Status taken = TakeTexture(options.job); !taken.ok()) return Fail(taken);
  if (absl::Status ok = CheckOutputs(options.job, options.output); !ok.ok()) return Fail(ok);
  if (UsesFarmPresets(options.job.presets))
    return Fail(Malformed(
        "--printer: --presets DIR|FILE is needed, too, because the preset is read from there"));
  const bool named = config::FindSetting("output_filename_format", options.job.process) >= 0;
  if (!named && IsNamedBySettings(options.output))
    return Fail(Malformed(fmt::format(
        "the output file is not named (-o FILE), and the settings of --machine {} give no name",
        ProcessName(options.job.process))));
  const auto settings = GivenJobSettings(options.job, options.output);
  if (!settings.ok()) return Fail(settings.status());
  auto models = ReadModels(options.job);
  if (!models.ok()) return Fail(models.status());
  PutOnBeds(options.job, *settings, *models);
  if (absl::Status all = ErrorOfAll(*models); !all.ok()) return Fail(all);
  for (size_t i = 0; i < models->plates.size(); ++i) {
    absl::Status may = CheckWritable(options.job, options.output, i);
    if (!may.ok()) return Fail(may);
  }
  return SlicePlates(options, *std::move(models), *settings, interrupt);
}

}  // namespace

void AddThreadsOption(CLI::App& app, int& threads) {
  app.add_option("--threads", threads,
                 "Number of threads; it does not change the result. Default: one per processor")
      ->check(InRange(1, kMaxThreads))
      ->type_name("N");
}

void AddSlice(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("slice", "Slice models or a project on this machine");
  const auto options = std::make_shared<SliceOptions>();  // as long as the callback lives
  AddJobOptions(*command, options->job);
  command
      ->add_option("-o,--output", options->output,
                   "File for the G-code or other output; -: to stdout; a folder: a file in it, "
                   "named by output_filename_format. Default: a file named by "
                   "output_filename_format, in the model's folder")
      ->type_name("OUT.gcode");
  command
      ->add_option(
          "--orient", options->job.texture.orient,
          "Direction of the texture's x axis at --anchor; `submit` has --set orient=X,Y,Z instead")
      ->type_name("X,Y,Z");
  AddThreadsOption(*command, options->threads);
  std::string of_processes;
  for (const ProcessInfo& info : kProcesses)
    if (const std::string_view example = config::SettingsOf(info.process).Example();
        !example.empty())
      of_processes += fmt::format("\n  {}", example);
  command->footer(
      "The output file appears when it is complete, or not at all. Ctrl-C cancels (exit code "
      "7).\nExamples:\n  slicefarm slice part.stl -o part.gcode --config prusa.ini\n  slicefarm "
      "slice project.3mf -o plate2.gcode --plate 2\n  slicefarm slice part.obj -o part.gcode --set "
      "layer_height=0.15 --set fill_density=30%\n  slicefarm slice bracket.stl -o - --units inch "
      "--rotate 90,0,0 | gzip > bracket.gcode.gz" +
      of_processes);
  command->callback([options, &context] {
    context.run = [options, &context] { return Slice(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
