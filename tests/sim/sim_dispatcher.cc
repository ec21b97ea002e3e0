#include "tests/sim/sim_dispatcher.h"

#include <algorithm>
#include <set>

#include "common/base/error.h"

namespace slicefarm::coordinator::sim {
namespace {

using std::chrono::milliseconds;

/// Intervals of the dispatcher, except that a slot checks less often for slow ranges.
constexpr int64_t kHedgePollUs = 250 * kMillisecondUs;
constexpr int64_t kReadyWaitUs = 200 * kMillisecondUs;
constexpr milliseconds kMinRest{20};
constexpr milliseconds kMaxRest{1000};

int64_t RestUs(int failures) {
  return std::chrono::microseconds(RestAfter(failures, kMinRest, kMaxRest)).count();
}

/// Returns true if the rule of SchedulerOptions ends a job because of a range with these failures.
bool MustPoison(const std::vector<RunnerId>& failed_on, int refusals) {
  const SchedulerOptions rule;
  const auto tries = static_cast<int>(failed_on.size());
  const auto runners =
      static_cast<int>(std::set<RunnerId>(failed_on.begin(), failed_on.end()).size());
  return tries >= rule.max_tries || refusals >= rule.refused_tries ||
         (tries >= rule.poison_tries && runners >= rule.poison_runners);
}

}  // namespace

void SimDispatcher::Begin() {
  fan_out_.emplace(world_.variant.scheduler);
  jobs_.clear();
  slots_.clear();
  calls_.clear();
  for (int worker = 0; worker < farm_.workers(); ++worker) Join(worker);
}

void SimDispatcher::End() {
  if (!fan_out_) return;
  const DispatchCounts counts = fan_out_->Counts();
  world_.totals.ranges += counts.done;
  world_.totals.requeued += counts.requeued;
  world_.totals.hedges += counts.hedged;
  world_.totals.poisoned += counts.poisoned;
  fan_out_.reset();
}

void SimDispatcher::Join(int worker) {
  const bool there = std::any_of(slots_.begin(), slots_.end(), [&](const Slot& slot) {
    return slot.worker == worker && !slot.left;
  });
  if (there) return;
  const RunnerId runner = next_runner_++;
  for (int i = 0; i < farm_.slots(worker); ++i) {
    slots_.push_back({.worker = worker, .runner = runner});
  }
  WorkNews();
}

void SimDispatcher::Leave(int worker) {
  for (Slot& slot : slots_) {
    if (slot.worker != worker || slot.left) continue;
    slot.left = true;
    fan_out_->RunnerGone(slot.runner);
  }
  WorkNews();
}

FanOut::JobId SimDispatcher::Execute(const Work& work, const std::string& build, Progress progress,
                                     Done done) {
  Job job{work, build, std::move(progress), std::move(done), {}};
  for (int32_t first = 0; first < work.layers;) {
    const auto last = std::min<int32_t>(work.layers, first + 1 + world_.random.Below(12));
    job.ranges.push_back({first, last});
    first = last;
  }
  const FanOut::JobId id = fan_out_->Add(static_cast<int32_t>(job.ranges.size()), work.process);
  jobs_.emplace(id, std::move(job));
  WorkNews();
  return id;
}

void SimDispatcher::GiveUp(FanOut::JobId job) {
  fan_out_->Remove(job);
  jobs_.erase(job);
  StopCalls([&](const Call& call) { return call.grant.job == job; });
}

void SimDispatcher::WorkNews() {
  for (Slot& slot : slots_) ServeLater(slot, 0);
}

void SimDispatcher::ServeLater(Slot& slot, int64_t delay_us) {
  process_.After(delay_us, [this, &slot] { Serve(slot); });
}

/// Gives the slot a range if there is one.
void SimDispatcher::Serve(Slot& slot) {
  if (slot.left || slot.busy || slot.waiting || jobs_.empty()) return;
  int64_t wait_us = kReadyWaitUs + RestUs(1);
  if (farm_.Reachable(coordinator_, slot.worker)) {
    const bool untold = world_.variant.processes_unreported;
    const ProcessSet can = untold ? ProcessSet::All() : farm_.can(slot.worker);
    if (const auto grant = fan_out_->Take(slot.runner, world_.events.now_s(), can)) {
      return Begin(slot, *grant);
    }
    if (fan_out_->MayTake(slot.runner, world_.events.now_s(), can))
      world_.Violated("c{}: a slot finds nothing to do", coordinator_);
    wait_us = kHedgePollUs;
  }
  slot.waiting = true;
  process_.After(wait_us, [this, &slot] {
    slot.waiting = false;
    Serve(slot);
  });
}

void SimDispatcher::Begin(Slot& slot, const FanOut::Grant& grant) {
  CheckCopies(slot, grant);
  slot.busy = true;
  const int64_t call = next_call_++;
  calls_[call] = {grant, &slot};
  const Job& job = jobs_.at(grant.job);
  const Range& range = job.ranges[grant.range];
  world_.Log("c{} has w{} make layers {} to {} of work {}", coordinator_, slot.worker, range.first,
             range.last - 1, job.work.id);
  farm_.Call(coordinator_, slot.worker, {job.work, job.build, range.first, range.last},
             [this, call, grant, life = process_.life()](const auto& answer) {
               if (life != process_.life()) return;
               process_.After(0, [this, call, grant, answer] { Answered(call, grant, answer); });
             });
}

/// Returns true if another copy of the range runs on a worker that has not left.
bool SimDispatcher::OtherCopies(const FanOut::Grant& grant) const {
  return std::any_of(calls_.begin(), calls_.end(), [&](const auto& entry) {
    const Call& call = entry.second;
    return call.grant.job == grant.job && call.grant.range == grant.range &&
           call.grant.ticket != grant.ticket && !call.stopped && !call.slot->left;
  });
}

void SimDispatcher::CheckCopies(const Slot& slot, const FanOut::Grant& grant) {
  int copies = 0;
  bool same_runner = false;
  for (const auto& [id, call] : calls_) {
    if (call.grant.job != grant.job || call.grant.range != grant.range) continue;
    if (call.stopped || call.slot->left) continue;
    ++copies;
    same_runner = same_runner || call.slot->runner == slot.runner;
  }
  if (copies > 1 || same_runner) {
    world_.Violated("c{}: range {} runs in {} copies and is given away again", coordinator_,
                    grant.range, copies);
  }
  if (jobs_.at(grant.job).ranges[grant.range].done) {
    world_.Violated("c{}: range {} is done and is given away again", coordinator_, grant.range);
  }
}

void SimDispatcher::Answered(int64_t call, const FanOut::Grant& grant,
                             const absl::StatusOr<RangeHashes>& answer) {
  const auto found = calls_.find(call);
  if (found == calls_.end()) {
    // The answer is doubled, or no call waits for it any more.
    if (answer.ok() && fan_out_->Succeeded(grant, world_.events.now_s()).first) {
      world_.Violated("c{}: an answer that was not waited for counts", coordinator_);
    }
    return;
  }
  const bool stopped = found->second.stopped;
  Slot& slot = *found->second.slot;
  calls_.erase(found);
  slot.busy = false;
  fan_out_->Returned(grant);
  const bool failed = !answer.ok() && !stopped;
  slot.failures = failed ? slot.failures + 1 : 0;
  ServeLater(slot, failed ? RestUs(slot.failures) : 0);
  if (!jobs_.contains(grant.job)) return;
  if (answer.ok()) {
    Accept(grant, *answer);
  } else if (stopped) {
    fan_out_->Superseded(grant);
  } else {
    Reject(slot, grant, answer.status());
  }
}

void SimDispatcher::Accept(const FanOut::Grant& grant, const RangeHashes& layers) {
  const auto accepted = fan_out_->Succeeded(grant, world_.events.now_s());
  if (!accepted.first && !jobs_.at(grant.job).ranges[grant.range].done) {
    world_.Violated("c{}: the first answer of range {} is dropped", coordinator_, grant.range);
  }
  if (!accepted.first && !world_.variant.every_answer_counts) return;
  StopCalls([&](const Call& call) {
    return call.grant.job == grant.job &&
           std::find(accepted.superfluous.begin(), accepted.superfluous.end(), call.grant.ticket) !=
               accepted.superfluous.end();
  });
  Job& job = jobs_.at(grant.job);
  Range& range = job.ranges[grant.range];
  range.done = true;
  range.layers = layers;
  job.layers_done += range.last - range.first;
  if (job.layers_done > job.work.layers) {
    world_.Violated("c{}: {} of {} layers are done", coordinator_, job.layers_done,
                    job.work.layers);
  }
  job.progress(job.layers_done);
  if (!fan_out_->AllDone(grant.job)) return;
  RangeHashes all;
  for (const Range& part : job.ranges)
    all.insert(all.end(), part.layers.begin(), part.layers.end());
  EndJob(grant.job, std::move(all));
}

void SimDispatcher::Reject(const Slot& slot, const FanOut::Grant& grant,
                           const absl::Status& error) {
  Range& range = jobs_.at(grant.job).ranges[grant.range];
  const bool counts = !slot.left && !absl::IsInvalidArgument(error) &&
                      DetailOf(error).reason != Reason::kBuildMismatch;
  if (counts) range.failed_on.push_back(slot.runner);
  if (counts && absl::IsInternal(error)) ++range.refusals;
  if (world_.variant.failures_unreported) return;
  const FanOut::Verdict verdict = fan_out_->Failed(grant, error);
  if (absl::IsInvalidArgument(error) != (verdict == FanOut::Verdict::kInputAtFault)) {
    world_.Violated("c{}: {} {} its job", coordinator_, error.ToString(),
                    absl::IsInvalidArgument(error) ? "does not end" : "ends");
  }
  if (counts) CheckPoison(range, verdict, OtherCopies(grant));
  switch (verdict) {
    case FanOut::Verdict::kGoesOn:
      return WorkNews();
    case FanOut::Verdict::kInputAtFault:
      return EndJob(grant.job, error);
    case FanOut::Verdict::kPoisoned:
      return EndJob(
          grant.job,
          MakeError(absl::StatusCode::kInternal, Reason::kRangePoisoned, "a range failed too often",
                    {{"cause", std::string(ReasonName(DetailOf(error).reason))}}));
  }
}

void SimDispatcher::CheckPoison(const Range& range, FanOut::Verdict verdict, bool other_copies) {
  const bool poisoned = verdict == FanOut::Verdict::kPoisoned;
  if (poisoned != (MustPoison(range.failed_on, range.refusals) && !other_copies)) {
    world_.Violated("c{}: a range {} after {} tries", coordinator_,
                    poisoned ? "ends its job" : "goes on", range.failed_on.size());
  }
}

/// Stops calls. The stop takes some time, and an answer may arrive before.
template <typename Which>
void SimDispatcher::StopCalls(const Which& which) {
  for (auto& [id, call] : calls_) {
    if (call.stopped || !which(call)) continue;
    call.stopped = true;
    process_.After(world_.random.Between(1, 20) * kMillisecondUs,
                   [this, id = id, grant = call.grant] {
                     if (calls_.contains(id)) Answered(id, grant, absl::CancelledError("stopped"));
                   });
  }
}

void SimDispatcher::EndJob(FanOut::JobId id, absl::StatusOr<RangeHashes> layers) {
  const Done done = jobs_.at(id).done;
  GiveUp(id);
  done(std::move(layers));
}

}  // namespace slicefarm::coordinator::sim
