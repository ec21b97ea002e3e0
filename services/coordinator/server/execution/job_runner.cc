#include "services/coordinator/server/execution/job_runner.h"

#include <utility>

#include "services/coordinator/run/run_conclusion.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/server/observe/job_log.h"

namespace slicefarm::coordinator {
namespace {

constexpr double kRequestIdSweepS = 3600;
/// Pause of a job that is returned to the queue because its stages are away. Each job of a long
/// queue gets a longer pause than the one before, so that few jobs a second are returned.
constexpr int64_t kUnfitPauseUs = 5'000'000;
constexpr int64_t kUnfitStepUs = 100'000;
constexpr int kJudgementsALease = 20;
constexpr int32_t kMaxOverdueAtOnce = 100;

}  // namespace

JobRunner::JobRunner(RunEnvironment environment, JobRunnerOptions options)
    : environment_(std::move(environment)),
      options_(std::move(options)),
      unfit_(environment_.stages_fit),
      leases_(std::chrono::microseconds(options_.lease).count()) {}

JobRunner::~JobRunner() { Stop(); }

absl::Status JobRunner::Start() {
  if (absl::Status released = environment_.jobs.Release(options_.owner); !released.ok()) {
    return released;
  }
  calm_since_us_ = NowUs();
  for (int i = 0; i < options_.jobs; ++i) {
    threads_.emplace_back([this] { Serve(SlotKind::kAny); });
  }
  for (int i = 0; i < options_.guests; ++i) {
    threads_.emplace_back([this] { Serve(SlotKind::kGuest); });
  }
  // With a thread of their own, interactive jobs do not wait for long jobs to end.
  threads_.emplace_back([this] { Serve(SlotKind::kInteractive); });
  threads_.emplace_back([this] { Keep(); });
  threads_.emplace_back([this] { Judge(); });
  threads_.emplace_back([this] { Tidy(); });
  return absl::OkStatus();
}

void JobRunner::Wake() {
  std::lock_guard lock(mutex_);
  ++wakes_;
  wake_.notify_all();
}

void JobRunner::Cancel(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  leases_.Cancel(job_id);
}

void JobRunner::Drain(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  draining_ = true;
  wake_.notify_all();
  wake_.wait_for(lock, patience, [this] { return at_work_ == 0; });
}

void JobRunner::Stop() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    leases_.HandBackAll();
    wake_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

/// Returns true if a thread of this kind may claim a job now. Guests may claim only if all slots of
/// kind kAny are taken; otherwise the limit `jobs` would have no effect. After each wake, only one
/// guest queries the store.
bool JobRunner::MayClaim(SlotKind slot) {
  if (slot != SlotKind::kGuest) return true;
  std::lock_guard lock(mutex_);
  if (at_any_ < options_.jobs || guests_asked_ == wakes_) return false;
  guests_asked_ = wakes_;
  return true;
}

/// Counts a run that begins (1) or ends (-1). Wakes the guests when all slots of kind kAny are
/// taken, and when another guest begins or ends.
void JobRunner::Count(SlotKind slot, int more) {
  std::lock_guard lock(mutex_);
  if (slot == SlotKind::kAny) at_any_ += more;
  if (slot == SlotKind::kInteractive || at_any_ < options_.jobs) return;
  ++wakes_;
  wake_.notify_all();
}

/// Claims and runs jobs on one thread until the runner stops or drains.
void JobRunner::Serve(SlotKind slot) {
  while (true) {
    int64_t seen = 0;
    {
      std::lock_guard lock(mutex_);
      if (stopping_ || draining_) return;
      seen = wakes_;
      ++at_work_;
    }
    const auto run = MayClaim(slot) ? Claim(slot) : nullptr;
    if (run) {
      Count(slot, 1);
      run->Run();
      Count(slot, -1);
      if (const auto process = run->met_unfit_stages(); process && unfit_.Add(*process))
        environment_.log.Warn(
            "stages are away or of another build: no such job starts until they fit",
            {{"process", std::string(ProcessName(*process))}});
    }
    std::unique_lock lock(mutex_);
    --at_work_;
    if (run) leases_.Remove(run->lease());
    if (run && run->lost()) calm_since_us_ = NowUs();
    if (draining_) wake_.notify_all();
    if (run) continue;
    const bool woken = wake_.wait_for(lock, options_.poll,
                                      [&] { return stopping_ || draining_ || wakes_ != seen; });
    if (!woken) ++wakes_;  // some jobs become claimable without a notification
  }
}

/// Gives a job of another build the identity that it has in this build. Its result is then searched
/// and stored under this identity. Returns false if another run works on the same action; then the
/// job is back in the queue. Also returns false if the store failed; then the job will be claimed
/// again.
bool JobRunner::Adopt(JobRecord& job) {
  const auto resolved =
      environment_.resolved.Of(job.spec, ResultTenant(environment_.sharing, job.tenant));
  if (!resolved.ok()) return true;  // the run will end with this error
  const JobIdentity identity = {(*resolved)->settings_digest, (*resolved)->action_digest,
                                environment_.build_id};
  const Lease lease{job.id, job.owner_epoch};
  const auto alone = environment_.jobs.Adopt(lease, identity, NowUs());
  if (!alone.ok()) return false;
  if (!*alone) {
    environment_.jobs.Update(lease, {.state = JobState::kQueued}, NowUs()).IgnoreError();
    environment_.feed.Changed(job.id);
    Wake();  // other jobs may be claimable
    return false;
  }
  job.settings_digest = identity.settings_digest;
  job.action_digest = identity.action_digest;
  job.build_id = identity.build_id;
  job.lost_runs = job.deadly_runs = 0;  // the store resets these counts as well
  return true;
}

/// Returns true if the stages of the job's process are not known to be away or of another build. A
/// job that is to be cancelled needs no stages.
bool JobRunner::StagesFit(const JobRecord& job) const {
  if (unfit_.empty() || job.cancel_requested) return true;
  const auto request = ReadSpec(job.spec);
  return !request.ok() || !unfit_.Has(request->process);  // the run will end with this error
}

/// Returns true if there is space for a result. Without this check, a run with a result that cannot
/// be stored would be repeated endlessly.
bool JobRunner::HasSpace() {
  const bool has_space = environment_.has_space();
  if (!has_space && !low_on_space_.exchange(true))
    environment_.log.Warn("the disk is nearly full: no job starts until there is space", {});
  if (has_space) low_on_space_ = false;
  return has_space;
}

/// Claims a job with stages that are not known to be unfit; nullopt if there is none. Returns other
/// jobs to the queue for some time, so that they do not hold up jobs of other processes.
absl::StatusOr<std::optional<JobRecord>> JobRunner::ClaimFitting(SlotKind slot, int64_t now_us) {
  const ClaimFilter filter = {
      .at_least = slot == SlotKind::kInteractive ? Priority::kInteractive : Priority::kBulk,
      .of_idle_tenants = slot == SlotKind::kGuest};
  for (int64_t pause_us = kUnfitPauseUs;; pause_us += kUnfitStepUs) {
    auto job = environment_.jobs.Claim(options_.owner, now_us, leases_.UntilUs(now_us), filter);
    if (!job.ok() || !*job || StagesFit(**job)) return job;
    JobUpdate back = {.state = JobState::kQueued};
    back.claimable_from_us = now_us + pause_us;
    back.lost_runs = (*job)->lost_runs;
    const auto returned = environment_.jobs.Update({(*job)->id, (*job)->owner_epoch}, back, now_us);
    if (!returned.ok()) return returned.status();
    environment_.feed.Changed((*job)->id);
  }
}

std::unique_ptr<JobRun> JobRunner::Claim(SlotKind slot) {
  std::lock_guard claiming(claim_mutex_);
  unfit_.Update();
  if (unfit_.HasAll(environment_.pipeline.processes()) || !HasSpace()) return nullptr;
  const int64_t now_us = NowUs();
  auto job = ClaimFitting(slot, now_us);
  if (!job.ok()) Warn("no job claimed", job.status());  // the next poll tries again
  if (!job.ok() || !*job) return nullptr;
  if ((*job)->build_id != environment_.build_id && !Adopt(**job)) return nullptr;
  std::lock_guard lock(mutex_);
  auto run = std::make_unique<JobRun>(environment_, **std::move(job), now_us - calm_since_us_);
  if (stopping_) run->wishes()->HandBack();
  leases_.Add(run->lease(), now_us, run->wishes());
  return run;
}

/// Renews the leases at regular intervals. This thread has no other work, so that no lease expires.
void JobRunner::Keep() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    RenewLeases();
    lock.lock();
    wake_.wait_for(lock, options_.renew, [this] { return stopping_; });
  }
}

void JobRunner::RenewLeases() {
  std::unique_lock lock(mutex_);
  const std::vector<Lease> leases = leases_.ToRenew();
  const int64_t until_us = leases_.UntilUs(NowUs());
  unanswered_ = true;
  lock.unlock();
  const auto held = environment_.jobs.Renew(leases, until_us);
  if (!held.ok()) Warn("leases not renewed", held.status());
  lock.lock();
  if (!held.ok()) return;
  unanswered_ = false;
  leases_.Renewed(leases, *held, until_us);
}

/// Ends overdue jobs and removes old request ids, on a thread of its own, because both can take
/// long and no lease may wait. Without it, a job at the end of a long queue would fail long after
/// its deadline.
void JobRunner::Tidy() {
  Stopwatch since_sweep;
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    const bool more = EndOverdue() == kMaxOverdueAtOnce;
    if (since_sweep.Seconds() > kRequestIdSweepS) {
      // On an error, the next sweep tries again.
      environment_.jobs.ExpireRequestIds(NowUs()).IgnoreError();
      since_sweep = Stopwatch();
    }
    lock.lock();
    if (!more) wake_.wait_for(lock, options_.renew, [this] { return stopping_; });
  }
}

/// Ends waiting jobs with a passed deadline. Returns the number of jobs.
int32_t JobRunner::EndOverdue() {
  const auto ended = environment_.jobs.EndOverdue(DeadlinePassed(), NowUs(), kMaxOverdueAtOnce);
  if (!ended.ok()) {
    Warn("overdue jobs not ended", ended.status());
    return 0;
  }
  for (const JobRecord& job : *ended) {
    environment_.log.Warn("waiting job ended at its deadline", FieldsOf(job));
    environment_.feed.Changed(job.id);
  }
  return static_cast<int32_t>(ended->size());
}

void JobRunner::Warn(const std::string& what, const absl::Status& why) const {
  environment_.log.Warn(what, {{"error", std::string(why.message())}});
}

/// Ends runs with leases that were not renewed in time. It has a thread of its own, because a store
/// without an answer blocks the renewal.
void JobRunner::Judge() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    if (unanswered_) leases_.GiveUpLate(NowUs());
    wake_.wait_for(lock, options_.lease / kJudgementsALease, [this] { return stopping_; });
  }
}

}  // namespace slicefarm::coordinator
