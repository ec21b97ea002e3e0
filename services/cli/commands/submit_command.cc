#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/config/missing_feature.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/scene_wire.h"
#include "common/wire/support/enum_wire.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/farm_presets.h"
#include "services/cli/farm/job_outcome.h"
#include "services/cli/farm/jobs_client.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/server_options.h"
#include "services/cli/farm/watch_bar.h"
#include "services/cli/job/job_options.h"
#include "services/cli/job/joined_plates.h"
#include "services/cli/job/output_name.h"
#include "services/cli/job/summary.h"
#include "services/cli/models/given_models.h"
#include "services/cli/models/texture_argument.h"

namespace slicefarm::cli {
namespace {

struct SubmitOptions {
  JobOptions job;
  ServerOptions server;
  std::string output;
  std::vector<std::string> labels;
  std::vector<std::string> profiles;
  std::string priority = "normal";
  double deadline_s = 0;  ///< 0: no deadline
  std::string webhook;
  bool quote = false;
  bool check = false;
  bool orient = false;
  std::string traceparent;
  bool detach = false;
  bool json = false;
  std::vector<std::string> told;  ///< warnings that were printed before the job was made
};

/// Reads the trace context. An invalid one is ignored, as the standard requires.
TraceContext TraceOf(const SubmitOptions& options) {
  const auto trace = ParseTraceparent(options.traceparent);
  if (!trace && !options.traceparent.empty()) {
    Warn({fmt::format("'{}' is no W3C trace context: the job gets its own", options.traceparent)});
  }
  return trace.value_or(TraceContext());
}

/// Returns the spec without the objects, which need the meshes' digests.
v1::JobSpec SpecOf(const SubmitOptions& submit, const GivenPlate& plate,
                   const std::vector<Setting>& settings) {
  v1::JobSpec spec;
  if (submit.job.process != kDefaultProcess)
    spec.set_process(EnumToProto<v1::Process>(submit.job.process));
  spec.mutable_profiles()->Assign(submit.profiles.begin(), submit.profiles.end());
  if (submit.quote) spec.set_mode(v1::JOB_MODE_QUOTE);
  SettingsToProto(settings, spec.mutable_settings());
  const std::vector<Setting> all = SettingsOf(plate, settings);
  std::vector<Setting> of_project = plate.settings;
  // Templates in the farm's profiles and presets may use the time, but only the farm can see them.
  const bool hidden = !submit.profiles.empty() || UsesFarmPresets(submit.job.presets);
  if (WithCreationTime(all, hidden).size() > all.size())
    of_project = WithCreationTime(std::move(of_project), true);
  SettingsToProto(of_project, spec.mutable_project_settings());
  spec.mutable_without_effect()->Assign(plate.without_effect.begin(), plate.without_effect.end());
  for (const std::string& warning : plate.warnings) spec.add_notes()->set_text(warning);
  for (const config::MissingFeature& each : plate.missing) {
    v1::ProjectNote& note = *spec.add_notes();
    note.set_text(each.text);
    note.set_feature(each.feature);
  }
  spec.mutable_allow()->Assign(submit.job.allow.begin(), submit.job.allow.end());
  spec.set_generic(submit.job.generic);
  SourcesToProto(plate.sources, spec.mutable_setting_sources());
  if (UsesFarmPresets(submit.job.presets) && plate.sources.empty())
    *spec.mutable_presets() = PresetsToProto(submit.job.presets);
  return spec;
}

v1::JobPriority PriorityOf(const std::string& name) {
  if (name == "bulk") return v1::JOB_PRIORITY_BULK;
  return name == "interactive" ? v1::JOB_PRIORITY_INTERACTIVE : v1::JOB_PRIORITY_NORMAL;
}

/// Returns the request without the objects.
absl::StatusOr<v1::CreateJobRequest> RequestOf(const SubmitOptions& options,
                                               const GivenPlate& plate,
                                               const std::vector<Setting>& settings) {
  const auto labels = ReadLabels(options.labels);
  if (!labels.ok()) return labels.status();
  v1::CreateJobRequest request;
  *request.mutable_spec() = SpecOf(options, plate, settings);
  request.mutable_labels()->insert(labels->begin(), labels->end());
  request.set_priority(PriorityOf(options.priority));
  request.set_webhook_url(options.webhook);
  request.set_validate_only(options.check);
  request.set_advise_orientations(options.orient);
  if (options.deadline_s > 0) {
    using google::protobuf::util::TimeUtil;
    *request.mutable_deadline() =
        TimeUtil::GetCurrentTime() +
        TimeUtil::MillisecondsToDuration(static_cast<int64_t>(options.deadline_s * 1000));
  }
  return request;
}

absl::StatusOr<std::vector<StoredMesh>> UploadMeshes(const std::vector<MeshFile>& files,
                                                     JobsClient& client, ProgressBar& bar) {
  constexpr int64_t kKib = 1024;
  int64_t total = 0;
  for (const MeshFile& file : files) total += std::ssize(file.bytes);
  std::vector<StoredMesh> meshes;
  int64_t before = 0;
  for (const MeshFile& file : files) {
    const auto sha256 = client.UploadMesh(file.bytes, [&](int64_t sent) {
      bar.Show("upload, KiB", static_cast<int>((before + sent) / kKib),
               static_cast<int>(total / kKib));
    });
    if (!sha256.ok()) return sha256.status();
    meshes.push_back({*sha256, file.name, file.format});
    before += std::ssize(file.bytes);
  }
  return meshes;
}

/// Creates the jobs of several plates. The farm puts the copies on beds, and makes all jobs or
/// none.
absl::StatusOr<std::vector<v1::Job>> CreatePlates(const SubmitOptions& options,
                                                  std::vector<v1::CreateJobRequest> requests,
                                                  JobsClient& client) {
  v1::CreatePlatesRequest all;
  all.set_validate_only(options.check);
  for (v1::CreateJobRequest& request : requests) {
    request.clear_validate_only();
    *all.add_requests() = std::move(request);
  }
  auto made = client.CreatePlates(std::move(all));
  if (!made.ok()) return made.status();
  return std::vector<v1::Job>(made->jobs().begin(), made->jobs().end());
}

/// Creates one job, or with --plates one for each plate.
absl::StatusOr<std::vector<v1::Job>> Create(SubmitOptions& options, JobsClient& client,
                                            ProgressBar& bar) {
  const auto settings = GivenJobSettings(options.job, options.output);
  if (!settings.ok()) return settings.status();
  std::optional<config::presets::PresetSet> presets;
  if (UsesFarmPresets(options.job.presets) && HasProject(options.job)) {
    auto fetched = FetchPresets(options.job.presets.bundles, client);
    if (!fetched.ok()) return fetched.status();
    presets = *std::move(fetched);
  }
  const auto models = ReadModels(options.job, presets ? &*presets : nullptr);
  if (!models.ok()) return models.status();
  if (absl::Status all = CheckPlates(*models); !all.ok()) return all;
  for (size_t i = 0; i < models->plates.size(); ++i)
    if (absl::Status may = CheckWritable(options.job, options.output, i); !may.ok()) return may;
  std::vector<v1::CreateJobRequest> requests;
  for (const GivenPlate& plate : models->plates) {
    if (absl::Status ok = config::CheckMissing(plate.missing, options.job.allow); !ok.ok())
      return ok;
    WarnOfRest(plate.warnings, options.told);
    std::ranges::copy(plate.warnings, std::back_inserter(options.told));
    auto request = RequestOf(options, plate, *settings);
    if (!request.ok()) return request.status();
    requests.push_back(*std::move(request));
  }
  const auto meshes = UploadMeshes(models->files, client, bar);
  if (!meshes.ok()) return meshes.status();
  for (size_t i = 0; i < requests.size(); ++i)
    for (const SceneObject& object : models->plates[i].objects)
      slicefarm::ToProto(object, *meshes, requests[i].mutable_spec()->add_objects());
  if (options.job.plates) return CreatePlates(options, std::move(requests), client);
  auto job = client.CreateJob(std::move(requests.front()));
  if (!job.ok()) return job.status();
  return std::vector<v1::Job>{*std::move(job)};
}

/// Checks that the jobs make the format of the output's name, as far as the farm's profiles are
/// known. The farm returns them with a single job, but not with the jobs of several plates.
absl::Status CheckMade(const SubmitOptions& options, const std::vector<v1::Job>& jobs,
                       JobsClient& client) {
  if (options.output.empty() || !options.job.format.empty() || jobs.empty() ||
      IsNamedBySettings(options.output))
    return absl::OkStatus();
  auto job = options.job.plates ? client.GetJob(jobs.front().id()) : jobs.front();
  if (!job.ok()) return job.status();
  std::vector<Setting> settings = SettingsFromProto(job->spec().project_settings());
  std::ranges::move(SettingsFromProto(job->spec().settings()), std::back_inserter(settings));
  const auto resolved = config::Resolve(settings, options.job.process);
  if (!resolved.ok()) return absl::OkStatus();  // the farm reports the error
  return CheckFormat(options.output, options.job.process, resolved->effective_text);
}

/// Cancels the job after Ctrl-C, because the user no longer wants it.
ExitCode CancelAfterInterrupt(const SubmitOptions& options, const std::string& id) {
  JobsClient client(ClientOptions(options.server, nullptr));
  const auto job = client.CancelJob(id);
  if (!job.ok()) {
    fmt::print(stderr, "job {} may continue: it could not be cancelled\n", id);
    Fail(job.status());
    return ExitCode::kCancelled;
  }
  if (job->state() == v1::JOB_STATE_FAILED) return FailJob(*job);
  if (job->state() == v1::JOB_STATE_SUCCEEDED) {
    fmt::print(
        stderr,
        "job {0} had already succeeded; `slicefarm get {0} -o OUT.gcode` fetches its result\n", id);
  } else {
    fmt::print(stderr, "job {} {}\n", id, HasEnded(*job) ? "was cancelled" : "is being cancelled");
  }
  return ExitCode::kCancelled;
}

/// Cancels a job if its result cannot be stored.
void CancelAfterError(const SubmitOptions& options, const std::string& id) {
  JobsClient client(ClientOptions(options.server, nullptr));
  if (const auto job = client.CancelJob(id); !job.ok()) {
    fmt::print(stderr, "job {} may continue: it could not be cancelled\n", id);
    Fail(job.status());
  }
}

config::ResultWords WordsOf(const SubmitOptions& options) {
  return config::SettingsOf(options.job.process).Words();
}

bool ResultIsOnStdout(const SubmitOptions& options) {
  return options.output == "-" || options.job.report == "-";
}

/// Prints the job as one line of JSON, without its settings, and with the file of its result.
void PrintJson(const SubmitOptions& options, const v1::Job& job, const std::string& output) {
  Print(JsonOfJob(job, output) + "\n", ResultIsOnStdout(options));
}

void PrintSummary(const SubmitOptions& options, const v1::Job& job, const std::string& output) {
  WarnOfRest({job.warnings().begin(), job.warnings().end()}, options.told);
  if (options.json) return PrintJson(options, job, output);
  if (options.job.quiet) return;
  const v1::JobResult& result = job.result();
  Print(SummaryText({.output = output == "-" ? "" : output,
                     .words = WordsOf(options),
                     .layers = result.layers(),
                     .print_time_s = result.print_time_s(),
                     .filament_mm = result.filament_mm(),
                     .filament_g = result.filament_g(),
                     .cost = MoneyText(result.cost().total(), result.cost().currency()),
                     .cached = result.cached(),
                     .job = job.id(),
                     .report = options.job.report}),
        ResultIsOnStdout(options));
}

absl::Status CheckWishes(const SubmitOptions& options) {
  const bool gcode = !options.output.empty();
  if (options.check && (gcode || !options.job.report.empty())) {
    return Malformed("--check does not slice: omit -o and --report");
  }
  if (options.check && (options.detach || options.quote)) {
    return Malformed("--check creates no job: omit --detach and --quote");
  }
  if (options.orient && !options.check) return Malformed("--orient works only with --check");
  if (options.quote && gcode) return Malformed("--quote makes no G-code: omit -o");
  if (options.detach && (gcode || !options.job.report.empty())) {
    return Malformed("--detach does not wait for results: fetch them with `slicefarm get`");
  }
  if (!gcode && !options.detach && !options.quote && !options.check) {
    return Malformed(
        "the output file is not named: use -o OUT.gcode, --detach, --quote or --check");
  }
  return CheckOutputs(options.job, options.output);
}

/// Returns a hint about an object that would print better in another orientation.
std::string AdviceText(const v1::OrientationAdvice& advice) {
  // A rotation by 0.001 degrees lifts the end of a part of 100 mm by 2 um.
  const auto angle = [&](int axis) {
    return std::round(advice.rotate_deg(axis) * 1000) / 1000 + 0.0;
  };
  const auto describe = [](const v1::Lying& lying) {
    return fmt::format("{:.1f} cm2 on the bed, {:.1f} cm2 of overhangs, {:.1f} mm high{}",
                       lying.contact_mm2() / 100, lying.overhang_mm2() / 100, lying.height_mm(),
                       lying.stable() ? "" : ", not stable");
  };
  return fmt::format(
      "{} would print better if rotated by {},{},{} degrees about x, y, z: {}; now: {}\n",
      advice.object(), angle(0), angle(1), angle(2), describe(advice.advised()),
      describe(advice.asked()));
}

void PrintPreflight(const SubmitOptions& options, const v1::Job& job) {
  WarnOfRest({job.warnings().begin(), job.warnings().end()}, options.told);
  if (options.json) return PrintJson(options, job, "");
  const v1::Preflight& found = job.preflight();
  for (const v1::MeshReport& mesh : found.meshes()) {
    const auto side = [&](int i) { return mesh.max_mm(i) - mesh.min_mm(i); };
    const bool closed = mesh.open_edges() == 0;
    Print(fmt::format("{}: {} triangles, {}, {:.1f} x {:.1f} x {:.1f} mm{}\n", mesh.name(),
                      mesh.triangles(), closed ? "closed" : "open", side(0), side(1), side(2),
                      closed ? fmt::format(", {:.1f} cm3", mesh.volume_mm3() / 1000) : ""));
  }
  for (const v1::OrientationAdvice& advice : found.orientations()) Print(AdviceText(advice));
  if (found.first_layer_area_mm2() > 0)
    Print(fmt::format("first layer: {:.1f} cm2\n", found.first_layer_area_mm2() / 100));
  Print("estimate: " +
        SummaryText({.words = WordsOf(options),
                     .layers = found.layers(),
                     .print_time_s = found.print_time_s(),
                     .filament_mm = found.filament_mm(),
                     .filament_g = found.filament_g(),
                     .cost = MoneyText(found.cost().total(), found.cost().currency())}));
}

/// Waits for the job and fetches its results.
ExitCode Fetch(const SubmitOptions& options, const v1::Job& created, JobsClient& client,
               Interrupt& interrupt) {
  WatchBar bar(!options.job.quiet, ClientOptions(options.server, &interrupt), created.id());
  const auto job = client.WatchJob(created.id(), [&](const v1::Job& event) { bar.Show(event); });
  bar.Clear();
  if (interrupt.Requested()) return CancelAfterInterrupt(options, created.id());
  if (!job.ok()) {
    fmt::print(stderr, "job {} continues; `slicefarm watch {}` follows it\n", created.id(),
               created.id());
    return Fail(job.status());
  }
  const auto& models = options.job.models;
  if (!OutcomeOf(*job).ok()) {
    if (options.json) PrintJson(options, *job, "");
    return FailJob(*job, models.size() == 1 ? models[0] : "");
  }
  const auto fetched =
      FetchResults(client, *job, {.gcode = options.output, .report = options.job.report});
  if (!fetched.ok()) {
    fmt::print(stderr, "job {0} is done; `slicefarm get {0} -o OUT.gcode` fetches it\n", job->id());
    return Fail(fetched.status());
  }
  // Events have no shares of objects.
  const auto whole = options.json ? client.GetJob(job->id()) : job;
  PrintSummary(options, whole.ok() ? *whole : *job, *fetched);
  return ExitCode::kOk;
}

/// Fetches all jobs, and continues if one fails. After Ctrl-C it cancels the rest.
ExitCode FetchAll(const SubmitOptions& options, const std::vector<v1::Job>& jobs,
                  JobsClient& client, Interrupt& interrupt) {
  ExitCode worst = ExitCode::kOk;
  for (size_t i = 0; i < jobs.size(); ++i) {
    SubmitOptions one = options;
    one.output = OutputOf(options.job, options.output, i);
    one.job.report = OutputOf(options.job, options.job.report, i);
    const ExitCode code = interrupt.Requested() ? CancelAfterInterrupt(options, jobs[i].id())
                                                : Fetch(one, jobs[i], client, interrupt);
    if (code != ExitCode::kOk) worst = code;
  }
  if (worst != ExitCode::kOk) return worst;
  const absl::Status joined = JoinPlates(options.job, options.output, jobs.size());
  return joined.ok() ? ExitCode::kOk : Fail(joined);
}

ExitCode Submit(SubmitOptions options, Interrupt& interrupt) {
  if (absl::Status taken = TakeTexture(options.job); !taken.ok()) return Fail(taken);
  if (absl::Status fits = CheckWishes(options); !fits.ok()) return Fail(fits);
  JobsClientOptions client_options = ClientOptions(options.server, &interrupt);
  client_options.trace = TraceOf(options);
  JobsClient client(std::move(client_options));
  ProgressBar bar(!options.job.quiet);
  const auto created = Create(options, client, bar);
  bar.Clear();
  if (!created.ok()) return Fail(created.status());
  if (absl::Status made = CheckMade(options, *created, client); !made.ok()) {
    for (const v1::Job& job : *created) CancelAfterError(options, job.id());
    return Fail(made);
  }
  Warn(WaitsOf(*created));
  if (!options.check && !options.detach) return FetchAll(options, *created, client, interrupt);
  for (const v1::Job& job : *created) {
    if (options.check) PrintPreflight(options, job);
    if (!options.detach) continue;
    if (options.json) {
      PrintJson(options, job, "");
    } else {
      Print(job.id() + "\n");
    }
  }
  return ExitCode::kOk;
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
  command
      ->add_option("--profile", options->profiles,
                   "Profile of settings that the farm stores (`slicefarm profile`); settings given "
                   "here override it. May be repeated")
      ->type_name("NAME[@REVISION]")
      ->allow_extra_args(false);
  command
      ->add_option("--bundle", options->job.presets.bundles,
                   "Bundle of presets that the farm stores (`slicefarm presets import`), for "
                   "--printer without --presets; default: the newest revisions of all bundles. May "
                   "be repeated")
      ->type_name("NAME[@REVISION]")
      ->allow_extra_args(false);
  command->add_option("--priority", options->priority, "Queue priority of the job")
      ->check(OneOf(std::vector<std::string>{"bulk", "normal", "interactive"}))
      ->capture_default_str();
  command
      ->add_option("--deadline", options->deadline_s,
                   "Seconds after which the job fails if it is not done")
      ->check(AboveZero())
      ->type_name("S");
  command
      ->add_option(
          "--webhook", options->webhook,
          "URL that receives the job by POST when the job has ended; the farm must allow the URL")
      ->type_name("URL");
  command->add_flag("--json", options->json,
                    "Print each job as one line of JSON: id, state, result, warnings, error, and "
                    "`output`, the file of the result");
  command->add_flag("--quote", options->quote,
                    "Compute only time, filament and cost; no G-code is made");
  command->add_flag("--check", options->check,
                    "Check whether the job can be made, and estimate it, without creating a job; "
                    "the farm stores only the mesh");
  command->add_flag("--orient", options->orient,
                    "Report objects that would print better in another orientation, with a large "
                    "face on the bed and little support (with --check)");
  command
      ->add_option("--traceparent", options->traceparent,
                   "Trace that the job belongs to (W3C Trace Context)")
      ->envname("TRACEPARENT")
      ->type_name("00-TRACE-SPAN-01");
  AddServerOptions(*command, options->server);
  command->footer(
      "After a broken connection the command and its upload continue from the point of "
      "interruption.\nCtrl-C cancels the job (exit code 7); a job submitted with --detach does not "
      "need this program.\nExamples:\n  slicefarm submit part.stl -o part.gcode --config prusa.ini "
      "--server farm:50050\n  slicefarm submit part.stl -o part.gcode --printer \"Prusa MK4\" "
      "--process \"0.20mm SPEED\" --filament \"Prusament PLA\"\n  job=$(slicefarm submit part.stl "
      "--detach) && slicefarm watch $job");
  command->callback([options, &context] {
    context.run = [options, &context] { return Submit(*options, *context.interrupt); };
  });
}

}  // namespace slicefarm::cli
