// Queue of MemoryJobStore in the order of serving.
#include <algorithm>
#include <map>
#include <tuple>

#include "services/coordinator/store/jobs/job_steps.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator {
namespace {

std::vector<const JobRecord*> Sorted(std::vector<const JobRecord*> jobs, const auto& key) {
  std::ranges::sort(jobs, {}, [&](const JobRecord* job) { return key(*job); });
  return jobs;
}

void AddLatestRuns(const std::vector<const JobRecord*>& ended, QueueSnapshot& queue) {
  const auto latest =
      Sorted(ended, [](const JobRecord& job) { return std::pair(-job.end_us, -job.number); });
  for (size_t i = 0; i < std::min(latest.size(), static_cast<size_t>(kLatestRuns)); ++i)
    if (latest[i]->start_us > 0) queue.runs_us.push_back(latest[i]->end_us - latest[i]->start_us);
}

void AddHeldSlots(const std::vector<const JobRecord*>& held, QueueSnapshot& queue) {
  const auto first = [](const JobRecord& job) {
    return std::tuple(job.start_us == 0, job.start_us, job.number);
  };
  for (const JobRecord* job : Sorted(held, first)) {
    const bool interactive = job->priority == Priority::kInteractive;
    queue.held.push_back({job->tenant, job->owner, interactive, job->start_us});
    if (!job->cancel_requested) queue.held_work.insert(job->action_digest);
  }
}

}  // namespace

absl::StatusOr<QueueSnapshot> MemoryJobStore::ReadQueue(int64_t now_us) {
  const std::lock_guard lock(jobs_.mutex_);
  std::vector<const JobRecord*> held, waiting, ended;
  for (const auto& [number, entry] : jobs_.entries_) {
    const JobRecord& job = entry.job;
    if (IsTerminal(job.state)) {
      ended.push_back(&job);
    } else {
      const bool is_held = !job.owner.empty() && job.owner_until_us > now_us;
      (is_held ? held : waiting).push_back(&job);
    }
  }
  QueueSnapshot queue;
  AddHeldSlots(held, queue);
  const auto next = [](const JobRecord& job) {
    return std::tuple(job.tenant, -static_cast<int>(job.priority), job.deadline_us, job.number);
  };
  for (const JobRecord* job : Sorted(waiting, next)) {
    if (queue.tenants.empty() || queue.tenants.back().tenant != job->tenant) {
      const auto turn = jobs_.turns_.find(job->tenant);
      queue.tenants.push_back({job->tenant, turn == jobs_.turns_.end() ? 0 : turn->second, {}});
    }
    queue.tenants.back().waiting.push_back({job->number, job->priority == Priority::kInteractive});
  }
  AddLatestRuns(ended, queue);
  return queue;
}

}  // namespace slicefarm::coordinator
