#include "services/coordinator/server/execution/job_run.h"

#include <chrono>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/cancel_scope.h"
#include "common/base/error.h"
#include "common/base/stoppable_sleep.h"
#include "services/coordinator/algo/job_trace.h"
#include "services/coordinator/algo/pipeline/report_json.h"
#include "services/coordinator/run/run_conclusion.h"
#include "services/coordinator/server/execution/job_meshes.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/server/observe/job_log.h"
#include "services/coordinator/server/observe/job_traces.h"

namespace slicefarm::coordinator {
namespace {

// Number of tries to write the last update. Together they last as long as the start of a database.
constexpr int kLastWrites = 50;
constexpr std::chrono::milliseconds kLastWritePause{200};

RunOutput OutputOf(JobOutput output, const ResolvedJob& job, std::string_view build_id) {
  JobReport& report = output.report;
  RunOutput run;
  run.report_json =
      ReportJson(report, {.settings_without_effect = config::TextsOf(job.plate.no_effect),
                          .settings_digest = job.settings_digest,
                          .build_id = std::string(build_id),
                          .calibration = job.request.calibration,
                          .sources = job.request.sources});
  run.program = std::move(output.program);
  run.result.print_time_s = report.print_time_s;
  run.result.filament_mm = report.filament.length_mm;
  run.result.filament_mm3 = report.filament.volume_mm3;
  run.result.filament_g = report.filament.mass_g;
  run.result.shares = std::move(report.shares);
  run.result.layers = report.layer_count;
  run.result.warnings = std::move(report.warnings);
  return run;
}

}  // namespace

JobRun::JobRun(RunEnvironment& environment, JobRecord job, int64_t calm_us)
    : environment_(environment),
      job_(std::move(job)),
      lost_runs_(job_, calm_us),
      result_tenant_(ResultTenant(environment.sharing, job_.tenant)),
      lease_{job_.id, job_.owner_epoch},
      spans_(environment.now_us(), kMaxJobSpans) {
  if (job_.cancel_requested) wishes_->Cancel();
}

void JobRun::Run() {
  RunSteps steps(lost_runs_);
  const auto next = [&] { return steps.Next(*wishes_, environment_.now_us()); };
  for (auto step = next(); step != RunSteps::Step::kOver; step = next()) {
    const auto ended = Take(step, steps.status());
    ended_ = ended.ok() && *ended;
    steps.Took(ended);
  }
  environment_.feed.Ended(job_.id, lease_.epoch);
  if (lost()) {
    environment_.log.Warn("job lost", Fields({{"seconds", clock_.Seconds()}}));
  } else if (steps.status().ok()) {
    environment_.log.Info("job done", Fields({{"seconds", clock_.Seconds()}}));
  }
}

absl::StatusOr<bool> JobRun::Take(RunSteps::Step step, const absl::Status& error) {
  switch (step) {
    case RunSteps::Step::kFindCached:
      return FindCached();
    case RunSteps::Step::kBegin:
      return Begin();
    case RunSteps::Step::kCompute:
      return Compute();
    case RunSteps::Step::kKeep:
      return Keep();
    case RunSteps::Step::kConclude:
      return Conclude(error);
    case RunSteps::Step::kOver:
      return true;
  }
  return true;
}

absl::StatusOr<bool> JobRun::FindCached() {
  auto resolved = environment_.resolved.Of(job_.spec, result_tenant_, GivenUp());
  if (!resolved.ok()) return resolved.status();
  resolved_ = *std::move(resolved);
  std::optional<ScopedSpan> looking(std::in_place, &spans_, "cache");
  const auto cached =
      environment_.results.SucceedFromCache(lease_, *resolved_, environment_.now_us());
  looking.reset();
  if (!cached.ok()) return Written(cached.status());
  if (*cached) Written(absl::OkStatus()).IgnoreError();
  return cached->has_value();
}

absl::StatusOr<bool> JobRun::Begin() {
  if (absl::Status written = Write({.state = JobState::kRunning}); !written.ok()) return written;
  return false;
}

absl::StatusOr<bool> JobRun::Compute() {
  std::optional<ScopedSpan> loading(std::in_place, &spans_, "meshes");
  const auto blobs = environment_.blobs.Of(job_.tenant);
  if (!blobs.ok()) return blobs.status();
  const CancelToken given_up = GivenUp();
  const CancelScope scope(given_up);
  StageCall call;
  call.job_id = job_.id;
  call.claimant = {job_.tenant, static_cast<int>(job_.priority)};
  call.trace = ChildSpan(TraceOf(job_), absl::StrCat("run ", job_.owner_epoch));
  call.spans = &spans_;
  call.cancel = given_up;
  const auto reserved = ReserveMeshMemory(call, *resolved_, **blobs, environment_.memory);
  if (!reserved.ok()) return reserved.status();
  call.memory = reserved->get();
  auto meshes = LoadMeshes(*resolved_, **blobs);
  if (!meshes.ok()) return meshes.status();
  loading.reset();
  const config::ResolvedPlate& plate = resolved_->plate;
  JobInput input{*std::move(meshes), plate.settings, plate.effective_text, plate.warnings};
  auto output = environment_.pipeline.Run(call, std::move(input),
                                          [&](PipelineProgress progress) { Progress(progress); });
  if (!output.ok()) return output.status();
  environment_.computed(output->report.stage_times);
  output_ = OutputOf(*std::move(output), *resolved_, environment_.build_id);
  return false;
}

absl::StatusOr<bool> JobRun::Keep() {
  std::optional<ScopedSpan> keeping(std::in_place, &spans_, "artifacts");
  std::optional<CancelScope> scope(std::in_place, GivenUp());
  auto update = environment_.results.Keep(*resolved_, *output_, result_tenant_);
  scope.reset();
  output_.reset();
  if (!update.ok()) return update.status();
  keeping.reset();
  update->trace_sha256 = KeepTrace("ok");
  if (absl::Status written = Write(*update); !written.ok()) return written;
  return true;
}

CancelToken JobRun::GivenUp() const {
  return CancelToken([this] { return wishes_->GivenUp(environment_.now_us()); });
}

/// Stores the trace of the run so far and returns its digest. Returns an empty string if the trace
/// cannot be stored, because a job must not fail for this reason.
std::string JobRun::KeepTrace(std::string_view outcome) {
  const Span whole = {"run",
                      "",
                      begin_us_,
                      spans_.NowUs(),
                      {{"coordinator", job_.owner},
                       {"epoch", absl::StrCat(job_.owner_epoch)},
                       {"outcome", std::string(outcome)}}};
  const auto kept = JobTraces(environment_.jobs, environment_.blobs).Keep(job_, spans_, whole);
  if (kept.ok()) return *kept;
  environment_.log.Warn("trace not stored",
                        Fields({{"error", std::string(kept.status().message())}}));
  return "";
}

rpc::LogFields JobRun::Fields(const rpc::LogFields& more) const {
  rpc::LogFields fields = FieldsOf(job_);
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

void JobRun::Progress(PipelineProgress progress) {
  if (!progress_.Passes(progress, clock_.Seconds())) return;
  environment_.feed.Progressed(
      job_.id, {lease_.epoch, environment_.now_us(), progress.total, progress.done});
}

absl::StatusOr<bool> JobRun::Conclude(const absl::Status& error) {
  JobUpdate update =
      Conclusion(job_, lost_runs_, *wishes_, error, progress_.reported(), environment_.now_us());
  const std::string reason(ReasonName(DetailOf(error).reason));
  if (resolved_ && (DetailOf(error).reason == Reason::kBuildMismatch || StageIsAway(error)))
    met_unfit_stages_ = resolved_->request.process;
  environment_.log.Warn("job not done", Fields({{"state", std::string(JobStateName(update.state))},
                                                {"seconds", clock_.Seconds()},
                                                {"code", absl::StatusCodeToString(error.code())},
                                                {"reason", reason},
                                                {"error", std::string(error.message())}}));
  update.trace_sha256 = KeepTrace(reason);
  const absl::Status written = WriteAtLast(update);
  if (written.ok()) return true;
  if (!wishes_->lost())
    environment_.log.Warn("job's state not written: it will be claimed again",
                          Fields({{"error", std::string(written.message())}}));
  return written;
}

/// Writes the last update of the run. A run without a last update counts as lost. So the write is
/// repeated if the store is unreachable for a moment, for example during its restart.
absl::Status JobRun::WriteAtLast(const JobUpdate& update) {
  const CancelToken in_vain([this] { return wishes_->lost() || wishes_->handed_back(); });
  absl::Status written = Write(update);
  for (int i = 1; i < kLastWrites && DetailOf(written).reason == Reason::kStoreFailed; ++i) {
    if (!SleepUnlessCancelled(in_vain, kLastWritePause).ok()) break;
    written = Write(update);
  }
  return written;
}

absl::Status JobRun::Write(JobUpdate update) {
  if (wishes_->lost()) return absl::AbortedError("fenced");
  update.lost_runs = lost_runs_.After(update.state);
  const auto job = environment_.jobs.Update(lease_, update, environment_.now_us());
  // A cancel or a new deadline may have arrived after the claim, before this run could be notified.
  if (update.state == JobState::kRunning && job.ok()) {
    wishes_->EndBy(job->deadline_us);
    if (job->cancel_requested) wishes_->Cancel();
  }
  return Written(job.status());
}

/// Handles the outcome of a write to the record.
absl::Status JobRun::Written(const absl::Status& status) {
  wishes_->Heard(status);
  if (status.ok()) environment_.feed.Changed(job_.id);
  return status;
}

}  // namespace slicefarm::coordinator
