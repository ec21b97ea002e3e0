#include "tests/sim/sim_run.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/run/run_conclusion.h"

namespace slicefarm::coordinator::sim {
namespace {

// Values of JobRun.
constexpr int kLastWrites = 50;
constexpr int64_t kLastWritePauseUs = 200 * kMillisecondUs;

JobUpdate Success(JobResult result) {
  JobUpdate update;
  update.state = JobState::kSucceeded;
  update.layers_total = update.layers_done = result.layers;
  update.result = std::move(result);
  return update;
}

}  // namespace

SimRun::SimRun(RunDesk& desk, Work work, JobRecord job, int64_t calm_us)
    : desk_(desk),
      work_(std::move(work)),
      job_(std::move(job)),
      lost_runs_(job_, calm_us),
      lease_{job_.id, job_.owner_epoch},
      wishes_(std::make_shared<RunRequests>(
          desk.world.variant.deadlines_unread ? kNoDeadlineUs : job_.deadline_us)),
      reported_{work_.layers, 0} {
  if (job_.cancel_requested && !desk.world.variant.cancels_unread) wishes_->Cancel();
}

void SimRun::Start(std::function<void()> over) {
  over_ = std::move(over);
  Advance();
}

void SimRun::Advance() {
  switch (steps_.Next(*wishes_, desk_.now_us())) {
    case RunSteps::Step::kFindCached:
      return FindCached();
    case RunSteps::Step::kBegin:
      return Write({.state = JobState::kRunning}, [this](const absl::Status& written) {
        Took(written.ok() ? absl::StatusOr<bool>(false) : written);
      });
    case RunSteps::Step::kCompute:
      return Compute();
    case RunSteps::Step::kKeep:
      return Keep();
    case RunSteps::Step::kConclude:
      return Conclude();
    case RunSteps::Step::kOver:
      return desk_.process.After(0, [self = shared_from_this()] { self->over_(); });
  }
}

void SimRun::Took(const absl::StatusOr<bool>& succeeded) {
  ended_ = succeeded.ok() && *succeeded;
  steps_.Took(succeeded);
  Advance();
}

/// Simulates JobResults::SucceedFromCache.
void SimRun::FindCached() {
  desk_.link.Do([action = job_.action_digest](JobStore& store) { return store.FindResult(action); },
                [self = shared_from_this()](const auto& found) {
                  if (!found.ok()) return self->Took(found.status());
                  if (!*found) return self->Took(false);
                  self->desk_.process.After(
                      self->desk_.world.random.Between(1, 30) * kMillisecondUs,
                      [self, result = **found] { self->CheckBlobs(result); });
                });
}

void SimRun::CheckBlobs(const JobResult& found) {
  World& world = desk_.world;
  for (const std::string& blob : {found.gcode_sha256, found.report_sha256}) {
    if (!world.blobs.Keep({found.tenant, blob}, world.wall_us())) return ForgetResult();
  }
  JobResult result = found;
  result.cached = true;
  Write(Success(std::move(result)), [this](const absl::Status& written) {
    if (absl::IsNotFound(written)) return Took(false);
    Took(written.ok() ? absl::StatusOr<bool>(true) : written);
  });
}

void SimRun::ForgetResult() {
  desk_.link.Do(
      [action = job_.action_digest](JobStore& store) { return store.ForgetResult(action); },
      [self = shared_from_this()](const absl::Status& forgotten) {
        self->Took(forgotten.ok() ? absl::StatusOr<bool>(false) : forgotten);
      });
}

void SimRun::Compute() {
  computing_ = true;
  if (!desk_.world.blobs.Has({job_.tenant, MeshOf(work_)})) {
    return Computed(MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound, "no mesh"));
  }
  if (job_.deadline_us != kNoDeadlineUs) {
    const int64_t left_us = std::max<int64_t>(0, job_.deadline_us - desk_.now_us());
    desk_.process.After(left_us, [self = shared_from_this()] { self->Notice(); });
  }
  desk_.process.After(desk_.world.random.Between(1, 500) * kMillisecondUs,
                      [self = shared_from_this()] { self->Sliced(); });
  Notice();
}

/// Handles the answer of the slicing stage.
void SimRun::Sliced() {
  if (!computing_) return;
  World& world = desk_.world;
  if (world.Until(world.slicing_away_until_us)) {
    return Computed(world.random.Chance(500)
                        ? absl::UnavailableError("no slicing")
                        : MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBuildMismatch,
                                    "slicing of another build"));
  }
  if (work_.fault == Work::Fault::kBadInput) {
    return Computed(BadInput());
  }
  if (work_.fault == Work::Fault::kKillsCoordinators) {
    return desk_.process.After(world.random.Between(0, 2 * kSecondUs), [self = shared_from_this()] {
      if (self->computing_) self->desk_.die();
    });
  }
  fan_out_ = desk_.dispatcher.Execute(
      work_, desk_.build, [this](int32_t done) { reported_.done = done; },
      [self = shared_from_this()](absl::StatusOr<RangeHashes> layers) {
        self->fan_out_.reset();
        self->Computed(std::move(layers));
      });
}

void SimRun::Notice() {
  if (!computing_ || !wishes_->GivenUp(desk_.now_us())) return;
  const int64_t poll_us = desk_.world.random.Between(0, 40 * kMillisecondUs);
  desk_.process.After(poll_us, [self = shared_from_this()] {
    if (!self->computing_) return;
    if (self->fan_out_) self->desk_.dispatcher.GiveUp(*std::exchange(self->fan_out_, std::nullopt));
    self->Computed(absl::CancelledError("given up"));
  });
}

void SimRun::Computed(absl::StatusOr<RangeHashes> layers) {
  computing_ = false;
  if (!layers.ok()) return Took(layers.status());
  layers_ = *std::move(layers);
  Took(false);
}

void SimRun::Keep() {
  desk_.process.After(desk_.world.random.Between(1, 30) * kMillisecondUs,
                      [self = shared_from_this()] { self->PutBlobs(); });
}

void SimRun::PutBlobs() {
  World& world = desk_.world;
  if (world.Until(world.disk_full_until_us)) {
    return Took(MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskFull, "disk full"));
  }
  JobResult result;
  result.gcode_sha256 = GcodeOf(layers_);
  result.report_sha256 = absl::StrCat("report-", job_.id, "-", lease_.epoch);
  result.layers = static_cast<int32_t>(layers_.size());
  for (const std::string& blob : {result.gcode_sha256, result.report_sha256}) {
    world.blobs.Put({result.tenant, blob}, world.wall_us());
  }
  Write(Success(std::move(result)), [this](const absl::Status& written) {
    Took(written.ok() ? absl::StatusOr<bool>(true) : written);
  });
}

void SimRun::Conclude() {
  const JobUpdate update =
      Conclusion(job_, lost_runs_, *wishes_, steps_.status(), reported_, desk_.now_us());
  WriteAtLast(update, kLastWrites);
}

/// Simulates JobRun::WriteAtLast, with at most `writes` tries.
void SimRun::WriteAtLast(const JobUpdate& update, int writes) {
  Write(update, [this, update, writes](const absl::Status& written) {
    const bool failed = DetailOf(written).reason == Reason::kStoreFailed;
    if (!failed || writes == 1 || wishes_->handed_back())
      return Took(written.ok() ? absl::StatusOr<bool>(true) : written);
    desk_.process.After(kLastWritePauseUs, [self = shared_from_this(), update, writes] {
      self->WriteAtLast(update, writes - 1);
    });
  });
}

void SimRun::Write(JobUpdate update, Then then) {
  if (wishes_->lost()) return then(absl::AbortedError("fenced"));
  update.lost_runs = lost_runs_.After(update.state);
  if (fenced_) desk_.world.Violated("{} is written to by who knows that it is fenced", job_.id);
  desk_.link.Do([lease = lease_, update, now_us = desk_.now_us()](
                    JobStore& store) { return store.Update(lease, update, now_us).status(); },
                [self = shared_from_this(), then = std::move(then)](const absl::Status& written) {
                  self->wishes_->Heard(written);
                  self->fenced_ = self->fenced_ || absl::IsAborted(written);
                  then(written);
                });
}

}  // namespace slicefarm::coordinator::sim
