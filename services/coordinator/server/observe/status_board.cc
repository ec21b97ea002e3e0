#include "services/coordinator/server/observe/status_board.h"

#include <fmt/core.h>

#include <chrono>
#include <utility>

#include "common/base/build_info.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kMaxRunning = 20;

void LookIntoStore(JobStore& jobs, JobCounts& job_counts, CoordinatorStatus& status) {
  auto open = jobs.CountOpen();
  auto counts = open.ok() ? job_counts.With(*open) : open.status();
  auto running = jobs.List({.all_tenants = true,
                            .states = {JobState::kRunning},
                            .oldest_first = true,
                            .limit = kMaxRunning});
  status.store_status.Update(counts.status());
  status.store_status.Update(open.status());
  status.store_status.Update(running.status());
  if (!status.store_status.ok()) return;
  status.jobs = *std::move(counts);
  status.open = *std::move(open);
  status.running = *std::move(running);
}

}  // namespace

CoordinatorStatus StatusBoard::Look() const {
  CoordinatorStatus status;
  status.name = sources_.name;
  status.build = fmt::format("{} ({})", Version(), BuildId());
  status.uptime_s = uptime_.Seconds();
  status.store = sources_.store;
  status.now_us = std::chrono::duration_cast<std::chrono::microseconds>(
                      std::chrono::system_clock::now().time_since_epoch())
                      .count();
  LookIntoStore(sources_.jobs, counts_, status);
  for (JobRecord& job : status.running) sources_.add_progress(job);
  status.disk = DiskOf(sources_.state_dir);
  status.runners = sources_.fleet.Runners();
  for (const auto& [stage, pool] : sources_.stages) status.replicas[stage] = pool->Addresses();
  status.problems = sources_.log.RecentProblems();
  return status;
}

}  // namespace slicefarm::coordinator
