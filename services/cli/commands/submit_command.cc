#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "services/cli/commands/commands.h"
#include "services/cli/commands/submitting.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/farm_presets.h"
#include "services/cli/models/texture_argument.h"

namespace slicefarm::cli {
namespace {

absl::Status CheckWishes(const SubmitOptions& options) {
  const bool gcode = !options.output.empty();
  if (options.check && (gcode || !options.job.report.empty())) {
    return Malformed("--check does not slice, so there is nothing to write: omit -o and --report");
  }
  if (options.check && (options.detach || options.quote)) {
    return Malformed("--check creates no job: omit --detach and --quote");
  }
  if (options.orient && !options.check) return Malformed("--orient works only with --check");
  if (options.quote && gcode) return Malformed("--quote makes no G-code: omit -o");
  if (absl::Status ok = CheckDetach(options); !ok.ok()) return ok;
  if (!gcode && !options.detach && !options.quote && !options.check) {
    return Malformed(
        "the output file is not named: use -o OUT.gcode, --detach, --quote or --check");
  }
  return CheckOutputs(options.job, options.output);
}

/// Reads the models. A project gets the presets of the farm, which do not know its designer's
/// changes, on this machine.
absl::StatusOr<GivenModels> ReadGiven(const SubmitOptions& options, JobsClient& client) {
  std::optional<config::presets::PresetSet> presets;
  if (UsesFarmPresets(options.job.presets) && HasProject(options.job)) {
    auto fetched = FetchPresets(options.job.presets.bundles, client);
    if (!fetched.ok()) return fetched.status();
    presets = *std::move(fetched);
  }
  auto models = ReadModels(options.job, presets ? &*presets : nullptr);
  if (!models.ok()) return models.status();
  if (absl::Status all = CheckPlates(*models); !all.ok()) return all;
  for (size_t i = 0; i < models->plates.size(); ++i)
    if (absl::Status may = CheckWritable(options.job, options.output, i); !may.ok()) return may;
  return models;
}

ExitCode Submit(SubmitOptions options, Interrupt& interrupt) {
  if (absl::Status taken = TakeTexture(options.job); !taken.ok()) return Fail(taken);
  if (absl::Status fits = CheckWishes(options); !fits.ok()) return Fail(fits);
  JobsClient client(OptionsOfClient(options, interrupt));
  const auto settings = GivenJobSettings(options.job, options.output);
  if (!settings.ok()) return Fail(settings.status());
  const auto models = ReadGiven(options, client);
  if (!models.ok()) return Fail(models.status());
  return SubmitModels(std::move(options), *models, *settings, client, interrupt);
}

}  // namespace

void AddSubmit(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("submit", "Slice on a farm and fetch the G-code when it is done");
  const auto options = std::make_shared<SubmitOptions>();
  AddJobOptions(*command, options->job);
  command
      ->add_option("-o,--output", options->output,
                   "File for the G-code; -: to stdout; a folder: a file in it, named by "
                   "output_filename_format")
      ->type_name("OUT.gcode");
  command->add_flag("--detach", options->detach, "Print the job's id and do not wait for the job");
  command
      ->add_option("--label", options->labels,
                   "Label that the farm stores with the job; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  AddFarmSettingOptions(*command, *options);
  command
      ->add_option("--priority", options->priority,
                   "Priority of the job among the jobs of its tenant: interactive jobs start "
                   "first, bulk jobs last")
      ->check(OneOf(std::vector<std::string>{"bulk", "normal", "interactive"}))
      ->capture_default_str();
  command
      ->add_option("--deadline", options->deadline_s,
                   "Seconds from now after which the job fails if it is not done")
      ->check(AboveZero())
      ->type_name("S");
  command
      ->add_option("--webhook", options->webhook,
                   "URL to which the farm sends the job by POST when the job has ended; the farm "
                   "must allow the URL")
      ->type_name("URL");
  command->add_flag("--json", options->json,
                    "Print each job as one line of JSON: id, state, result, warnings, error, and "
                    "`output`, the file of the result");
  command->add_flag("--quote", options->quote,
                    "Compute only print time, filament and cost, without G-code");
  command->add_flag("--check", options->check,
                    "Check whether the farm can make the job, and estimate it, without creating a "
                    "job; the farm stores only the mesh");
  command->add_flag("--orient", options->orient,
                    "Report objects that would print better in another orientation, with a larger "
                    "face on the bed and less support; only with --check");
  command
      ->add_option("--traceparent", options->traceparent,
                   "Trace in your monitoring to which the job's spans are added, in the form of "
                   "W3C Trace Context")
      ->envname("TRACEPARENT")
      ->type_name("00-TRACE-SPAN-01");
  AddServerOptions(*command, options->server);
  command->footer(
      "After a broken connection the command continues, and its upload resumes where it was "
      "interrupted.\nCtrl-C cancels the job (exit code 7); a job submitted with --detach does not "
      "need this program.\nExamples:\n  slicefarm submit part.stl -o part.gcode --config prusa.ini "
      "--server farm:50050\n  slicefarm submit part.stl -o part.gcode --printer \"Prusa MK4 0.4 "
      "nozzle\" --process \"0.20mm Standard\" --filament \"Prusa Generic PLA\"\n  job=$(slicefarm "
      "submit part.stl --detach) && slicefarm watch $job");
  command->callback([options, &context] {
    context.run = [options, &context] { return Submit(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
