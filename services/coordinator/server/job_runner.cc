#include "services/coordinator/server/job_runner.h"

#include <utility>

#include "services/coordinator/server/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr double kRequestIdSweepS = 3600;

absl::StatusOr<JobIdentity> IdentityOf(const JobRecord& record, const std::string& build_id,
                                       ResultSharing sharing) {
  auto request = ReadSpec(record.spec);
  if (!request.ok()) return request.status();
  auto job = ResolveJob(*std::move(request), build_id, ResultTenant(sharing, record.tenant));
  if (!job.ok()) return job.status();
  return JobIdentity{std::move(job->settings_digest), std::move(job->action_digest), build_id};
}

}  // namespace

JobRunner::JobRunner(RunEnvironment environment, JobRunnerOptions options)
    : environment_(std::move(environment)), options_(std::move(options)) {}

JobRunner::~JobRunner() { Stop(); }

absl::Status JobRunner::Start() {
  if (absl::Status released = environment_.jobs.Release(options_.owner); !released.ok()) {
    return released;
  }
  for (int i = 0; i < options_.jobs; ++i) threads_.emplace_back([this] { Serve(); });
  threads_.emplace_back([this] { Keep(); });
  return absl::OkStatus();
}

void JobRunner::Wake() {
  std::lock_guard lock(mutex_);
  ++wakes_;
  wake_.notify_all();
}

void JobRunner::Cancel(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  for (const auto& [lease, held] : runs_) {
    if (lease.job_id == job_id) held.run->Cancel();
  }
}

void JobRunner::Stop() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    for (const auto& [lease, held] : runs_) held.run->HandBack();
    wake_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

/// The life of one of the threads that run jobs.
void JobRunner::Serve() {
  while (true) {
    int64_t seen = 0;
    {
      std::lock_guard lock(mutex_);
      if (stopping_) return;
      seen = wakes_;
    }
    if (const auto run = Claim()) {
      run->Run();
      std::lock_guard lock(mutex_);
      runs_.erase(run->lease());
      continue;
    }
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, options_.poll, [&] { return stopping_ || wakes_ != seen; });
  }
}

/// The work that is being done.
std::set<std::string> JobRunner::Busy() {
  std::lock_guard lock(mutex_);
  std::set<std::string> busy;
  for (const auto& [lease, held] : runs_) busy.insert(held.run->action_digest());
  return busy;
}

/// A job that another build made is another action here: its result must be found and kept under
/// the name that this build gives it. False: the same is being worked on, so the job is back in the
/// queue; or the store failed, so it will be claimed again.
bool JobRunner::Adopt(JobRecord& job) {
  const auto identity = IdentityOf(job, environment_.build_id, environment_.sharing);
  if (!identity.ok()) return true;  // the run will end with that error
  const Lease lease{job.id, job.owner_epoch};
  if (!environment_.jobs.Adopt(lease, *identity).ok()) return false;
  if (Busy().contains(identity->action_digest)) {
    environment_.jobs.Update(lease, {.state = JobState::kQueued}, NowUs()).IgnoreError();
    environment_.feed.Changed(job.id);
    Wake();  // there may be others
    return false;
  }
  job.settings_digest = identity->settings_digest;
  job.action_digest = identity->action_digest;
  job.build_id = identity->build_id;
  return true;
}

std::shared_ptr<JobRun> JobRunner::Claim() {
  std::lock_guard claiming(claim_mutex_);
  const int64_t now_us = NowUs();
  auto job = environment_.jobs.Claim(options_.owner, now_us, now_us + LeaseUs(), Busy());
  if (!job.ok() || !*job) return nullptr;  // a store that fails is asked again soon
  if ((*job)->build_id != environment_.build_id && !Adopt(**job)) return nullptr;
  auto run = std::make_shared<JobRun>(environment_, **std::move(job));
  std::lock_guard lock(mutex_);
  if (stopping_) run->HandBack();
  runs_[run->lease()] = {run, now_us + LeaseUs()};
  return run;
}

/// Holds the leases, and forgets old request ids.
void JobRunner::Keep() {
  Stopwatch since_sweep;
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    RenewLeases();
    if (since_sweep.Seconds() > kRequestIdSweepS) {
      environment_.jobs.ExpireRequestIds(NowUs()).IgnoreError();  // the next sweep comes
      since_sweep = Stopwatch();
    }
    lock.lock();
    wake_.wait_for(lock, options_.renew, [this] { return stopping_; });
  }
}

void JobRunner::RenewLeases() {
  const std::vector<Lease> leases = Leases();
  const int64_t until_us = NowUs() + LeaseUs();
  const auto held = environment_.jobs.Renew(leases, until_us);
  if (held.ok()) {
    Renewed(leases, *held, until_us);
  } else {
    GiveUpLate();
  }
}

/// Of the runs that go on. One that was given up writes nothing any more, so its job has to run
/// out, to be claimed again.
std::vector<Lease> JobRunner::Leases() {
  std::lock_guard lock(mutex_);
  std::vector<Lease> leases;
  for (const auto& [lease, held] : runs_) {
    if (!held.run->lost()) leases.push_back(lease);
  }
  return leases;
}

void JobRunner::Renewed(const std::vector<Lease>& asked, const std::vector<HeldJob>& held,
                        int64_t until_us) {
  std::map<Lease, bool> cancel_requested;
  for (const HeldJob& job : held) cancel_requested[job.lease] = job.cancel_requested;
  std::lock_guard lock(mutex_);
  for (const Lease& lease : asked) {
    const auto found = runs_.find(lease);
    if (found == runs_.end()) continue;  // has ended meanwhile
    auto& [run, run_until_us] = found->second;
    const auto still = cancel_requested.find(lease);
    if (still == cancel_requested.end()) {
      run->Lose();  // claimed by another; or written to its end, and then this changes nothing
      continue;
    }
    run_until_us = until_us;
    if (still->second) run->Cancel();
  }
}

/// The store does not answer: rather stop too early than work beside another coordinator.
void JobRunner::GiveUpLate() {
  std::lock_guard lock(mutex_);
  for (const auto& [lease, held] : runs_) {
    if (NowUs() > held.until_us - LeaseUs() / 5) held.run->Lose();
  }
}

}  // namespace slicefarm::coordinator
