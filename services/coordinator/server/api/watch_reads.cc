#include "services/coordinator/server/api/watch_reads.h"

#include <utility>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator {

absl::Status CoordinatorStops() {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   "the coordinator stops; watch again from the last sequence",
                   {{rpc::kRetryAfterMs, "1000"}});
}

WatchReads::WatchReads(JobStore& jobs, int threads) : jobs_(jobs) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { Run(); });
}

void WatchReads::Read(const std::string& tenant, const std::string& job_id, int64_t sequence,
                      Done done) {
  {
    const std::lock_guard lock(mutex_);
    if (!stopping_) {
      const auto [found, first] = tenants_.try_emplace(tenant);
      if (first) turns_.push_back(tenant);
      Tenant& asking = found->second;
      const Wanted wanted = {job_id, sequence};
      std::vector<Done>& waiting = asking.waiting[wanted];
      if (waiting.empty()) asking.queue.push_back(wanted);
      waiting.push_back(std::move(done));
      changed_.notify_one();
      return;
    }
  }
  done(CoordinatorStops());
}

/// Reads for one tenant after another, on one thread, until Stop.
void WatchReads::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !turns_.empty(); });
    if (turns_.empty()) return;
    const std::string name = std::move(turns_.front());
    turns_.pop_front();
    Tenant& tenant = tenants_.at(name);
    const Wanted wanted = std::move(tenant.queue.front());
    tenant.queue.pop_front();
    // Requests that come from now on need a new read, because this read may miss events that are
    // written after its start.
    const std::vector<Done> waiting = std::move(tenant.waiting.extract(wanted).mapped());
    if (tenant.queue.empty()) {
      tenants_.erase(name);
    } else {
      turns_.push_back(name);
    }
    const bool stopping = stopping_;
    lock.unlock();
    const Result result = stopping ? Result(CoordinatorStops()) : ReadNow(name, wanted);
    for (const Done& done : waiting) done(result);
    lock.lock();
  }
}

/// Reads the events first and then the job. So if the last event is among the events, the job is
/// already terminal, and the watch ends with this event.
WatchReads::Result WatchReads::ReadNow(const std::string& tenant, const Wanted& wanted) {
  auto events = jobs_.Events(wanted.job_id, wanted.sequence, kEventsAtOnce);
  auto job = events.ok() ? jobs_.GetWithoutSpec(wanted.job_id)
                         : absl::StatusOr<JobRecord>(events.status());
  if (absl::IsDataLoss(job.status()) && jobs_.TenantOf(wanted.job_id).value_or("") != tenant)
    return JobNotFound(wanted.job_id);
  if (!job.ok()) return job.status();
  return std::make_shared<const JobSteps>(JobSteps{*std::move(job), *std::move(events)});
}

void WatchReads::Stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

}  // namespace slicefarm::coordinator
