#include "services/cli/commands/submitting.h"

#include <fmt/core.h>
#include <google/protobuf/util/time_util.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "common/config/missing_feature.h"
#include "common/config/presets/overlay_names.h"
#include "common/wire/calibration_wire.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/scene_wire.h"
#include "common/wire/support/enum_wire.h"
#include "services/cli/calibration/solid_builder.h"
#include "services/cli/console/console.h"
#include "services/cli/farm/farm_presets.h"
#include "services/cli/farm/job_outcome.h"
#include "services/cli/farm/json_text.h"
#include "services/cli/farm/watch_bar.h"
#include "services/cli/job/joined_plates.h"
#include "services/cli/job/output_name.h"
#include "services/cli/job/summary.h"

namespace slicefarm::cli {
namespace {

/// Reads the trace context. An invalid one is ignored, as the standard requires.
TraceContext TraceOf(const SubmitOptions& options) {
  const auto trace = ParseTraceparent(options.traceparent);
  if (!trace && !options.traceparent.empty()) {
    Warn({fmt::format(
        "'{}' is not a W3C trace context (--traceparent): the job gets a trace of its own",
        options.traceparent)});
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
  if (!submit.calibration.kind.empty())
    *spec.mutable_calibration() = slicefarm::ToProto(submit.calibration);
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

/// Adds the farm's overlays of presets that the client has resolved. The farm adds the overlays of
/// presets that the spec names.
absl::Status AddOverlays(const GivenPlate& plate, JobsClient& client, v1::JobSpec& spec) {
  if (plate.presets.printer.empty()) return absl::OkStatus();
  const auto newest = [&](const std::string& name) -> absl::StatusOr<int64_t> {
    v1::GetProfileRequest get;
    get.set_name(name);
    const auto found = client.GetProfile(get);
    if (!found.ok()) return found.status();
    return found->revision();
  };
  const auto all = config::presets::WithOverlays(
      plate.presets, {spec.profiles().begin(), spec.profiles().end()}, newest);
  if (!all.ok()) return all.status();
  spec.mutable_profiles()->Assign(all->begin(), all->end());
  return absl::OkStatus();
}

/// Returns the requests of all plates, without objects.
absl::StatusOr<std::vector<v1::CreateJobRequest>> RequestsOf(SubmitOptions& options,
                                                             const GivenModels& models,
                                                             const std::vector<Setting>& settings,
                                                             JobsClient& client) {
  std::vector<v1::CreateJobRequest> requests;
  for (const GivenPlate& plate : models.plates) {
    if (absl::Status ok = config::CheckMissing(plate.missing, options.job.allow); !ok.ok())
      return ok;
    WarnOfRest(plate.warnings, options.reported);
    std::ranges::copy(plate.warnings, std::back_inserter(options.reported));
    auto request = RequestOf(options, plate, settings);
    if (!request.ok()) return request.status();
    if (absl::Status ok = AddOverlays(plate, client, *request->mutable_spec()); !ok.ok()) return ok;
    requests.push_back(*std::move(request));
  }
  return requests;
}

/// Creates one job, or with --plates one for each plate.
absl::StatusOr<std::vector<v1::Job>> Create(SubmitOptions& options, const GivenModels& models,
                                            const std::vector<Setting>& settings,
                                            JobsClient& client, ProgressBar& bar) {
  auto requests = RequestsOf(options, models, settings, client);
  if (!requests.ok()) return requests.status();
  const auto meshes = UploadMeshes(models.files, client, bar);
  if (!meshes.ok()) return meshes.status();
  for (size_t i = 0; i < requests->size(); ++i)
    for (const SceneObject& object : models.plates[i].objects)
      slicefarm::ToProto(object, *meshes, (*requests)[i].mutable_spec()->add_objects());
  if (options.job.plates) return CreatePlates(options, *std::move(requests), client);
  auto job = client.CreateJob(std::move(requests->front()));
  if (!job.ok()) return job.status();
  return std::vector<v1::Job>{*std::move(job)};
}

std::vector<Setting> SettingsOf(const v1::JobSpec& spec) {
  std::vector<Setting> settings = SettingsFromProto(spec.project_settings());
  std::ranges::move(SettingsFromProto(spec.settings()), std::back_inserter(settings));
  return settings;
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
  const auto resolved = config::Resolve(SettingsOf(job->spec()), options.job.process);
  if (!resolved.ok()) return absl::OkStatus();  // the farm reports the error
  return CheckFormat(options.output, options.job.process, resolved->effective_text);
}

/// Cancels the job after Ctrl-C, because the user no longer wants it.
ExitCode CancelAfterInterrupt(const SubmitOptions& options, const std::string& id) {
  JobsClient client(ClientOptions(options.server, nullptr));
  const auto job = client.CancelJob(id);
  if (!job.ok()) {
    fmt::print(stderr, "job {} could not be cancelled and may continue\n", id);
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
    fmt::print(stderr, "job {} could not be cancelled and may continue\n", id);
    Fail(job.status());
  }
}

config::ResultWords WordsOf(const SubmitOptions& options) {
  return config::SettingsOf(options.job.process).Words();
}

/// Prints the job as one line of JSON, without its settings, and with the file of its result.
void PrintJson(const SubmitOptions& options, const v1::Job& job, const std::string& output) {
  Print(JsonOfJob(job, output) + "\n", ResultIsOnStdout(options.job, options.output));
}

void PrintSummary(const SubmitOptions& options, const v1::Job& job, const std::string& output) {
  WarnOfRest({job.warnings().begin(), job.warnings().end()}, options.reported);
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
        ResultIsOnStdout(options.job, options.output));
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
  WarnOfRest({job.warnings().begin(), job.warnings().end()}, options.reported);
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

}  // namespace

absl::Status CheckDetach(const SubmitOptions& options) {
  if (!options.detach || (options.output.empty() && options.job.report.empty()))
    return absl::OkStatus();
  return Malformed("--detach does not wait for results: fetch them with `slicefarm get`");
}

JobsClientOptions OptionsOfClient(const SubmitOptions& options, Interrupt& interrupt) {
  JobsClientOptions client_options = ClientOptions(options.server, &interrupt);
  client_options.trace = TraceOf(options);
  return client_options;
}

absl::StatusOr<std::vector<Setting>> SettingsOnFarm(const SubmitOptions& options,
                                                    const GivenPlate& plate,
                                                    const std::vector<Setting>& settings,
                                                    JobsClient& client) {
  auto request = RequestOf(options, plate, settings);
  if (!request.ok()) return request.status();
  if (absl::Status ok = AddOverlays(plate, client, *request->mutable_spec()); !ok.ok()) return ok;
  SolidBuilder cube;
  cube.AddBox({0, 0, 0}, {10, 10, 10});
  ProgressBar bar(false);
  const auto meshes = UploadMeshes({{"cube", MeshFormat::kStl, cube.Stl()}}, client, bar);
  if (!meshes.ok()) return meshes.status();
  slicefarm::ToProto(ObjectOfFile("cube", 0, Placement{}, 1), *meshes,
                     request->mutable_spec()->add_objects());
  request->set_validate_only(true);
  const auto job = client.CreateJob(*std::move(request));
  if (!job.ok()) return job.status();
  return SettingsOf(job->spec());
}

ExitCode SubmitModels(SubmitOptions options, const GivenModels& models,
                      const std::vector<Setting>& settings, JobsClient& client,
                      Interrupt& interrupt) {
  ProgressBar bar(!options.job.quiet);
  const auto created = Create(options, models, settings, client, bar);
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

void AddFarmSettingOptions(CLI::App& app, SubmitOptions& options) {
  app.add_option("--profile", options.profiles,
                 "Profile of settings that the farm stores (`slicefarm profile`); settings given "
                 "here override it. May be repeated")
      ->type_name("NAME[@REVISION]")
      ->allow_extra_args(false);
  app.add_option("--bundle", options.job.presets.bundles,
                 "Bundle of presets that the farm stores (`slicefarm presets import`), for "
                 "--printer without --presets; default: the newest revisions of all bundles. May "
                 "be repeated")
      ->type_name("NAME[@REVISION]")
      ->allow_extra_args(false);
}

}  // namespace slicefarm::cli
