#include "services/coordinator/algo/dispatch/fan_out.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

/// Returns true if the input is at fault. Such an error is the same on every runner and for every
/// try.
bool IsFinal(const absl::Status& status) {
  return absl::IsInvalidArgument(status) || absl::IsOutOfRange(status);
}

/// Returns true if the runner reports that it cannot make the range. Such a runner would refuse the
/// range again; a busy runner would not.
bool IsRefusal(const absl::Status& status) { return absl::IsInternal(status); }

/// Returns true if the connection to the runner broke and no server gave a reason. The runner then
/// probably died of its task. A server that stops or is busy reports so.
bool IsDeath(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  const auto lost = detail.metadata.find("lost");
  const bool unreported =
      detail.metadata.empty() || (lost != detail.metadata.end() && lost->second == "connection");
  return absl::IsUnavailable(status) && detail.reason == Reason::kUnavailable && unreported;
}

}  // namespace

FanOut::JobId FanOut::Add(int32_t ranges, Process process, Claimant claimant) {
  const JobId id = next_job_++;
  jobs_.emplace(id, Job{RangeScheduler(ranges, options_), std::move(claimant), process});
  return id;
}

void FanOut::Remove(JobId job) {
  const auto found = jobs_.find(job);
  if (found == jobs_.end()) return;
  counts_.requeued += found->second.scheduler.Requeued();
  counts_.hedged += found->second.scheduler.Hedged();
  jobs_.erase(found);
}

/// Returns the jobs of these processes; the job that is next in turn comes first. Cost: O(n log n).
std::vector<FanOut::JobId> FanOut::Order(ProcessSet can) const {
  using Load = std::pair<int32_t, int64_t>;  // ranges in flight; turn of the last range
  std::map<std::string, Load> tenants;
  for (const auto& [id, job] : jobs_) {
    auto& [running, last_turn] = tenants[job.claimant.tenant];
    running += job.scheduler.Running();
    last_turn = std::max(last_turn, job.last_turn);
  }
  std::vector<std::tuple<Load, int, Load, JobId>> keys;
  for (const auto& [id, job] : jobs_) {
    if (!can.Has(job.process)) continue;
    keys.emplace_back(tenants.at(job.claimant.tenant), -job.claimant.priority,
                      Load(job.scheduler.Running(), job.last_turn), id);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<JobId> order;
  for (const auto& key : keys) order.push_back(std::get<JobId>(key));
  return order;
}

/// Returns the oldest job with a suspect range that the runner may get.
std::optional<FanOut::JobId> FanOut::SuspectsJob(RunnerId runner, double now_s, ProcessSet can) {
  for (auto& [id, job] : jobs_)
    if (can.Has(job.process) && job.scheduler.MayTakeSuspect(runner, now_s)) return id;
  return std::nullopt;
}

/// Returns true if the runner gets no more ranges until it is idle, because a suspect range could
/// run on it then. Only one runner is kept free at a time.
bool FanOut::IsKeptFree(RunnerId runner, double now_s, ProcessSet can) {
  if (loads_.IsTaken(runner)) return true;
  if (!AnySuspects()) kept_free_.reset();
  if (loads_.AnyAlone() || loads_.MayTakeAlone(runner) || !SuspectsJob(runner, now_s, can))
    return false;
  if (!kept_free_) kept_free_ = runner;
  return kept_free_ == runner;
}

bool FanOut::MayTake(RunnerId runner, double now_s, ProcessSet can) {
  if (std::ranges::any_of(jobs_, [&](auto& job) { return job.second.scheduler.Misses(runner); }))
    return true;  // to be seen
  if (loads_.MayTakeAlone(runner) && SuspectsJob(runner, now_s, can)) return true;
  return AnyQueued(can) && !IsKeptFree(runner, now_s, can);
}

std::optional<FanOut::Grant> FanOut::Take(RunnerId runner, double now_s, ProcessSet can) {
  for (auto& [id, job] : jobs_) job.scheduler.Seen(runner);
  if (loads_.MayTakeAlone(runner)) {
    if (const auto id = SuspectsJob(runner, now_s, can)) {
      Job& job = jobs_.at(*id);
      kept_free_.reset();
      return Granted(*id, job, runner, *job.scheduler.NextSuspect(runner, now_s));
    }
  }
  if (IsKeptFree(runner, now_s, can)) return std::nullopt;
  const std::vector<JobId> order = Order(can);
  for (const JobId id : order) {
    Job& job = jobs_.at(id);
    if (const auto grant = job.scheduler.Next(runner, now_s))
      return Granted(id, job, runner, *grant);
  }
  if (hedges_left_ < 1) return std::nullopt;
  for (const JobId id : order) {
    Job& job = jobs_.at(id);
    const auto grant = job.scheduler.Hedge(runner, now_s);
    if (!grant) continue;
    --hedges_left_;
    return Granted(id, job, runner, *grant);
  }
  return std::nullopt;
}

FanOut::Grant FanOut::Granted(JobId id, Job& job, RunnerId runner,
                              const RangeScheduler::Grant& grant) {
  job.last_turn = next_turn_++;
  loads_.Begin(runner, {id, grant.ticket}, grant.suspect);
  return {id, grant.ticket, grant.range, grant.suspect};
}

RangeScheduler::Accepted FanOut::Succeeded(const Grant& grant, double now_s) {
  Returned(grant);
  RangeScheduler* scheduler = Find(grant.job);
  if (!scheduler) return {};
  auto accepted = scheduler->Succeeded(grant.ticket, now_s);
  if (!accepted.first) return accepted;
  ++counts_.done;
  hedges_left_ = std::min(options_.hedge_burst, hedges_left_ + options_.hedge_share);
  return accepted;
}

FanOut::Verdict FanOut::Failed(const Grant& grant, const absl::Status& error) {
  Returned(grant);
  RangeScheduler* scheduler = Find(grant.job);
  if (!scheduler) return Verdict::kGoesOn;
  if (IsFinal(error)) return Verdict::kInputAtFault;
  if (DetailOf(error).reason == Reason::kBuildMismatch) {
    scheduler->Abandoned(grant.ticket);  // says nothing of the range
    return Verdict::kGoesOn;
  }
  if (IsDeath(error))
    scheduler->Died(grant.ticket);
  else if (IsRefusal(error))
    scheduler->Refused(grant.ticket);
  else
    scheduler->Failed(grant.ticket);
  if (scheduler->Poisoned() != grant.range) return Verdict::kGoesOn;
  ++counts_.poisoned;
  return Verdict::kPoisoned;
}

void FanOut::Superseded(const Grant& grant) {
  Returned(grant);
  if (RangeScheduler* scheduler = Find(grant.job)) scheduler->Failed(grant.ticket);
}

void FanOut::RunnerGone(RunnerId runner) {
  loads_.Gone(runner);
  if (kept_free_ == runner) kept_free_.reset();
  for (auto& [id, job] : jobs_) job.scheduler.RunnerGone(runner);
}

bool FanOut::AnyQueued(ProcessSet can) const {
  return std::ranges::any_of(jobs_, [can](const auto& job) {
    return can.Has(job.second.process) && job.second.scheduler.Queued() > 0;
  });
}

bool FanOut::AnySuspects() const {
  return std::ranges::any_of(jobs_,
                             [](const auto& job) { return job.second.scheduler.Suspects() > 0; });
}

DispatchCounts FanOut::Counts() const {
  DispatchCounts counts = counts_;
  for (const auto& [id, job] : jobs_) {
    counts.requeued += job.scheduler.Requeued();
    counts.hedged += job.scheduler.Hedged();
    counts.waiting += job.scheduler.Queued() + job.scheduler.Suspects();
  }
  return counts;
}

RangeScheduler* FanOut::Find(JobId job) {
  const auto found = jobs_.find(job);
  return found == jobs_.end() ? nullptr : &found->second.scheduler;
}

std::chrono::milliseconds RestAfter(int failures, std::chrono::milliseconds min,
                                    std::chrono::milliseconds max) {
  return std::min(max, min * (1 << std::clamp(failures - 1, 0, 10)));
}

}  // namespace slicefarm::coordinator
