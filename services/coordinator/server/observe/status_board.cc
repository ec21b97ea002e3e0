#include "services/coordinator/server/observe/status_board.h"

#include <fmt/core.h>

#include <chrono>
#include <utility>

#include "common/base/build_info.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kMaxRunning = 20;

}  // namespace

StatusBoard::StoreFacts StatusBoard::LookIntoStore() {
  StoreFacts facts;
  auto open = sources_.jobs.CountOpen();
  auto jobs = open.ok() ? counts_.With(*open) : open.status();
  auto running = sources_.jobs.List({.all_tenants = true,
                                     .states = {JobState::kRunning},
                                     .oldest_first = true,
                                     .limit = kMaxRunning});
  facts.status = jobs.status();
  facts.status.Update(running.status());
  if (!facts.status.ok()) return facts;
  facts.jobs = *std::move(jobs);
  facts.open = *std::move(open);
  facts.running = *std::move(running);
  return facts;
}

CoordinatorStatus StatusBoard::Look() const {
  CoordinatorStatus status;
  status.name = sources_.name;
  status.build = fmt::format("{} ({})", Version(), BuildId());
  status.uptime_s = uptime_.Seconds();
  status.store = sources_.store;
  status.now_us = std::chrono::duration_cast<std::chrono::microseconds>(
                      std::chrono::system_clock::now().time_since_epoch())
                      .count();
  auto store = store_.Get();
  if (!store) store.emplace().status = absl::UnavailableError("no answer yet");
  status.store_status = store->status;
  status.jobs = std::move(store->jobs);
  status.open = std::move(store->open);
  status.running = std::move(store->running);
  for (JobRecord& job : status.running) sources_.add_progress(job);
  status.disk = DiskOf(sources_.state_dir);
  status.runners = sources_.fleet.Runners();
  for (const auto& [stage, pool] : sources_.stages) status.replicas[stage] = pool->Addresses();
  status.problems = sources_.log.RecentProblems();
  return status;
}

}  // namespace slicefarm::coordinator
