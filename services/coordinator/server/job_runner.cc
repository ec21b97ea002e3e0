#include "services/coordinator/server/job_runner.h"

#include <set>
#include <utility>

namespace slicefarm::coordinator {
namespace {

constexpr double kRequestIdSweepS = 3600;

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
  if (const auto run = runs_.find(job_id); run != runs_.end()) run->second->Cancel();
}

void JobRunner::Stop() {
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    for (const auto& [id, run] : runs_) run->HandBack();
    wake_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

int64_t JobRunner::LeaseEndUs() const {
  return NowUs() + std::chrono::microseconds(options_.lease).count();
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
      runs_.erase(run->lease().job_id);
      continue;
    }
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, options_.poll, [&] { return stopping_ || wakes_ != seen; });
  }
}

std::shared_ptr<JobRun> JobRunner::Claim() {
  auto jobs = environment_.jobs.Claim(options_.owner, 1, NowUs(), LeaseEndUs());
  if (!jobs.ok() || jobs->empty()) return nullptr;  // a store that fails is asked again soon
  auto run = std::make_shared<JobRun>(environment_, std::move(jobs->front()));
  std::lock_guard lock(mutex_);
  if (stopping_) run->HandBack();
  runs_[run->lease().job_id] = run;
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
  std::vector<std::shared_ptr<JobRun>> runs;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [id, run] : runs_) runs.push_back(run);
  }
  const auto held = environment_.jobs.Renew(options_.owner, LeaseEndUs());
  if (!held.ok()) {
    // Rather stop too early than work beside another coordinator.
    const double lease_s = std::chrono::duration<double>(options_.lease).count();
    if (since_renewal_.Seconds() < 0.8 * lease_s) return;
    for (const auto& run : runs) run->Lose();
    return;
  }
  since_renewal_ = Stopwatch();
  std::map<Lease, bool> cancel_requested;
  for (const HeldJob& job : *held) cancel_requested[job.lease] = job.cancel_requested;
  for (const auto& run : runs) {
    const auto found = cancel_requested.find(run->lease());
    if (found != cancel_requested.end() && found->second) run->Cancel();
    // A run that is missing has ended, or was claimed by another: its next write tells.
  }
}

}  // namespace slicefarm::coordinator
