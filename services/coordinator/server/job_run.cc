#include "services/coordinator/server/job_run.h"

#include <algorithm>
#include <utility>

#include "common/model/error.h"
#include "services/coordinator/algo/report_json.h"
#include "services/coordinator/server/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kMaxRetries = 5;
constexpr int64_t kFirstRetryUs = 500'000;
constexpr int64_t kDiskFullRetryUs = 10'000'000;
constexpr int64_t kMaxStoreRetryUs = 60'000'000;
/// Progress is told at most this often, and a hundred times a job.
constexpr double kProgressEveryS = 0.2;
constexpr int32_t kProgressSteps = 100;

/// True if the services that are needed are not there; for some time there may be others in their
/// places, of another build, or some that do not know this coordinator.
bool IsAway(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsPermissionDenied(status) ||
         absl::IsUnauthenticated(status) || DetailOf(status).reason == Reason::kBuildMismatch;
}

RunOutput OutputOf(JobOutput output, const ResolvedJob& job, std::string_view build_id) {
  JobReport& report = output.report;
  RunOutput run;
  run.report_json = ReportJson(report, {.settings_without_effect = job.settings.no_effect,
                                        .settings_digest = job.settings_digest,
                                        .build_id = std::string(build_id)});
  run.gcode = std::move(output.gcode);
  run.result.print_time_s = report.print_time_s;
  run.result.filament_mm = report.filament.length_mm;
  run.result.filament_g = report.filament.mass_g;
  run.result.layers = report.layer_count;
  run.result.warnings = std::move(report.warnings);
  return run;
}

}  // namespace

JobRun::JobRun(RunEnvironment& environment, JobRecord job)
    : environment_(environment),
      job_(std::move(job)),
      result_tenant_(ResultTenant(environment.sharing, job_.tenant)),
      lease_{job_.id, job_.owner_epoch},
      cancelled_(job_.cancel_requested) {}

void JobRun::Run() {
  const absl::Status status = Work();
  if (status.ok()) {
    environment_.log.Info("job done", {{"job", job_.id}, {"seconds", clock_.Seconds()}});
  } else {
    Conclude(status);
  }
}

/// OK: the job has ended as SUCCEEDED.
absl::Status JobRun::Work() {
  if (Overdue()) return absl::DeadlineExceededError("before it began");
  auto request = ReadSpec(job_.spec);
  if (!request.ok()) return request.status();
  auto resolved = ResolveJob(*std::move(request), environment_.build_id, result_tenant_);
  if (!resolved.ok()) return resolved.status();
  const auto cached =
      environment_.results.SucceedFromCache(lease_, resolved->action_digest, environment_.now_us());
  if (!cached.ok()) return Written(cached.status());
  if (*cached) return Written(absl::OkStatus());
  if (absl::Status written = Write({.state = JobState::kRunning}); !written.ok()) return written;
  return Compute(*std::move(resolved));
}

absl::Status JobRun::Compute(ResolvedJob job) {
  auto meshes = LoadMeshes(job.request);
  if (!meshes.ok()) return meshes.status();
  StageCall call;
  call.job_id = job_.id;
  call.cancel = CancelToken([this] { return GivenUp(); });
  JobInput input{*std::move(meshes), job.settings.settings, job.settings.effective_text,
                 job.settings.warnings};
  auto output = environment_.pipeline.Run(call, std::move(input),
                                          [this](PipelineProgress p) { Progress(p); });
  if (!output.ok()) return output.status();
  if (lost_) return absl::AbortedError("fenced");
  return Written(environment_.results
                     .Succeed(lease_, OutputOf(*std::move(output), job, environment_.build_id),
                              result_tenant_, environment_.now_us())
                     .status());
}

absl::StatusOr<SliceInput> JobRun::LoadMeshes(const JobRequest& request) {
  SliceInput input;
  const auto blobs = environment_.blobs.Of(job_.tenant);
  if (!blobs.ok()) return blobs.status();
  for (const ObjectRequest& object : request.objects) {
    auto bytes = (*blobs)->Get(object.mesh_sha256);
    if (!bytes.ok()) return bytes.status();
    input.files.push_back({object.name, object.format, *std::move(bytes)});
    input.placements.push_back(object.placement);
  }
  return input;
}

void JobRun::Progress(PipelineProgress progress) {
  const double now_s = clock_.Seconds();
  const int32_t step = progress.layers_total / kProgressSteps + 1;
  const bool first = told_.layers_total == 0;
  if (!first &&
      (now_s - told_at_s_ < kProgressEveryS || progress.layers_done - told_.layers_done < step)) {
    return;
  }
  told_ = progress;
  told_at_s_ = now_s;
  // Progress that cannot be written is not worth ending the job for.
  Write({.state = JobState::kRunning,
         .layers_total = progress.layers_total,
         .layers_done = progress.layers_done})
      .IgnoreError();
}

void JobRun::Conclude(const absl::Status& status) {
  const JobUpdate update = Conclusion(status);
  environment_.log.Warn(lost_ ? "job lost" : "job not done",
                        {{"job", job_.id},
                         {"state", std::string(JobStateName(update.state))},
                         {"seconds", clock_.Seconds()},
                         {"code", absl::StatusCodeToString(status.code())},
                         {"reason", std::string(ReasonName(DetailOf(status).reason))},
                         {"error", std::string(status.message())}});
  const absl::Status written = Write(update);
  if (written.ok() || lost_) return;
  environment_.log.Warn("job's state not written: it will be claimed again",
                        {{"job", job_.id}, {"error", std::string(written.message())}});
}

JobUpdate JobRun::Conclusion(const absl::Status& status) const {
  JobUpdate update;
  update.state = JobState::kQueued;
  update.layers_total = told_.layers_total;
  const int64_t now_us = environment_.now_us();
  if (cancelled_) {
    update.state = JobState::kCancelled;
    update.layers_done = told_.layers_done;
  } else if (handed_back_) {
    update.claimable_from_us = now_us;
  } else if (Overdue()) {
    update.state = JobState::kFailed;
    update.layers_done = told_.layers_done;
    update.error =
        JobErrorOf(MakeError(absl::StatusCode::kDeadlineExceeded, Reason::kDeadlineExceeded,
                             "the job's deadline has passed"));
  } else if (DetailOf(status).reason == Reason::kDiskFull) {
    update.claimable_from_us = now_us + kDiskFullRetryUs;
  } else if (DetailOf(status).reason == Reason::kStoreFailed) {
    // Says nothing of the job, so however often it happens, it does not end it.
    update.claimable_from_us =
        now_us + std::min(kMaxStoreRetryUs, kFirstRetryUs << std::min(job_.store_failures, 10));
    update.store_failed = true;
  } else if (IsAway(status) && job_.retries < kMaxRetries) {
    update.claimable_from_us = now_us + (kFirstRetryUs << job_.retries);
    update.retry = true;
  } else {
    update.state = JobState::kFailed;
    update.layers_done = told_.layers_done;
    update.error = JobErrorOf(status);
  }
  return update;
}

absl::Status JobRun::Write(const JobUpdate& update) {
  if (lost_) return absl::AbortedError("fenced");
  return Written(environment_.jobs.Update(lease_, update, environment_.now_us()).status());
}

/// What follows a write to the record.
absl::Status JobRun::Written(const absl::Status& status) {
  if (absl::IsAborted(status)) lost_ = true;
  if (status.ok()) environment_.feed.Changed(job_.id);
  return status;
}

}  // namespace slicefarm::coordinator
