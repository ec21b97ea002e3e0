#include "services/coordinator/algo/dispatch/range_scheduler.h"

#include <algorithm>
#include <numeric>

#include "common/model/layers/job_plan.h"

namespace slicefarm::coordinator {

RangeScheduler::RangeScheduler(int32_t range_count, const SchedulerOptions& options)
    : options_(options), ranges_(range_count), queue_(range_count) {
  std::iota(queue_.begin(), queue_.end(), 0);
}

std::optional<RangeScheduler::Grant> RangeScheduler::Next(RunnerId runner, double now_s) {
  if (queue_.empty() || poisoned_) return std::nullopt;
  const auto untried = std::find_if(queue_.begin(), queue_.end(), [&](int32_t range) {
    return !ranges_[range].failed_on.contains(runner);
  });
  const auto chosen = untried != queue_.end() ? untried : queue_.begin();
  const int32_t range = *chosen;
  queue_.erase(chosen);
  return Start(range, runner, now_s);
}

std::optional<RangeScheduler::Grant> RangeScheduler::Hedge(RunnerId runner, double now_s) {
  if (poisoned_) return std::nullopt;
  const double slow_s =
      std::max(options_.hedge_after_s, options_.hedge_after_ratio * slowest_done_s_);
  // Ticket numbers increase, so the first match has run longest.
  for (const auto& [ticket, copy] : running_) {
    if (now_s - copy.since_s < slow_s) break;
    const Range& range = ranges_[copy.range];
    if (range.done || range.suspect || copy.runner == runner || range.copies != 1) continue;
    // The last running copy of a range that has failed too often decides about the job. If each
    // failed copy were replaced, the job would never end.
    if (FailedTooOften(range)) continue;
    ++hedged_;
    return Start(copy.range, runner, now_s);
  }
  return std::nullopt;
}

/// Returns the first suspect range that the runner may get. Starts the waiting time of each suspect
/// range that it checks.
std::deque<int32_t>::iterator RangeScheduler::SuspectFor(RunnerId runner, double now_s) {
  if (poisoned_) return suspects_.end();
  return std::find_if(suspects_.begin(), suspects_.end(), [&](int32_t index) {
    Range& range = ranges_[index];
    if (!range.waits_since_s) range.waits_since_s = now_s;
    const bool has_its_turn = range.alone_on.empty() ? range.failed_on.contains(runner)
                                                     : !range.alone_on.contains(runner);
    const bool may_die = !range.away || range.away == runner;
    return (has_its_turn && may_die) || now_s - *range.waits_since_s >= options_.elsewhere_after_s;
  });
}

void RangeScheduler::Seen(RunnerId runner) {
  for (const int32_t suspect : suspects_)
    if (ranges_[suspect].away == runner) ranges_[suspect].away.reset();
}

bool RangeScheduler::Misses(RunnerId runner) const {
  return std::any_of(suspects_.begin(), suspects_.end(),
                     [&](int32_t suspect) { return ranges_[suspect].away == runner; });
}

bool RangeScheduler::MayTakeSuspect(RunnerId runner, double now_s) {
  return SuspectFor(runner, now_s) != suspects_.end();
}

std::optional<RangeScheduler::Grant> RangeScheduler::NextSuspect(RunnerId runner, double now_s) {
  const auto chosen = SuspectFor(runner, now_s);
  if (chosen == suspects_.end()) return std::nullopt;
  const int32_t range = *chosen;
  suspects_.erase(chosen);
  ranges_[range].waits_since_s.reset();
  ranges_[range].alone_on.insert(runner);
  Grant grant = Start(range, runner, now_s);
  grant.suspect = true;
  return grant;
}

RangeScheduler::Grant RangeScheduler::Start(int32_t range, RunnerId runner, double now_s) {
  const Ticket ticket = next_ticket_++;
  running_.emplace(ticket, Copy{range, runner, now_s});
  ++ranges_[range].copies;
  return {ticket, range};
}

RangeScheduler::Accepted RangeScheduler::Succeeded(Ticket ticket, double now_s) {
  int32_t range = 0;
  if (const auto found = running_.find(ticket); found != running_.end()) {
    range = found->second.range;
    slowest_done_s_ = std::max(slowest_done_s_, now_s - found->second.since_s);
    --ranges_[range].copies;
    running_.erase(found);
  } else if (const auto lost = lost_.find(ticket); lost != lost_.end()) {
    range = lost->second;
    lost_.erase(lost);
  } else {
    return {};
  }
  if (ranges_[range].done) return {};
  ranges_[range].done = true;
  ++done_;
  std::erase(queue_, range);  // a range with a late result may be in the queue again
  std::erase(suspects_, range);

  Accepted accepted{.first = true};
  for (const auto& [other, copy] : running_) {
    if (copy.range == range) accepted.superfluous.push_back(other);
  }
  for (const auto& [other, lost_range] : lost_) {
    if (lost_range == range) accepted.superfluous.push_back(other);
  }
  return accepted;
}

/// Removes the copy and returns it. Returns nullopt if the range is done or if the copy was lost
/// before.
std::optional<RangeScheduler::Copy> RangeScheduler::Stopped(Ticket ticket) {
  lost_.erase(ticket);
  const auto found = running_.find(ticket);
  if (found == running_.end()) return std::nullopt;
  const Copy copy = found->second;
  running_.erase(found);
  --ranges_[copy.range].copies;
  if (ranges_[copy.range].done) return std::nullopt;
  return copy;
}

void RangeScheduler::Failed(Ticket ticket) {
  const std::optional<Copy> copy = Stopped(ticket);
  if (!copy) return;
  CountFailure(copy->range, copy->runner);
  Requeue(copy->range);
}

void RangeScheduler::Refused(Ticket ticket) {
  if (const auto found = running_.find(ticket); found != running_.end())
    ++ranges_[found->second.range].refusals;
  Failed(ticket);
}

void RangeScheduler::Died(Ticket ticket) {
  const std::optional<Copy> copy = Stopped(ticket);
  if (!copy) return;
  ranges_[copy->range].suspect = true;
  ranges_[copy->range].away = copy->runner;
  CountFailure(copy->range, copy->runner);
  Requeue(copy->range);
}

void RangeScheduler::Abandoned(Ticket ticket) {
  if (const std::optional<Copy> copy = Stopped(ticket)) Requeue(copy->range);
}

void RangeScheduler::RunnerGone(RunnerId runner) {
  Seen(runner);  // no suspect range waits for this runner any more
  std::vector<Ticket> gone;
  for (const auto& [ticket, copy] : running_) {
    if (copy.runner == runner) gone.push_back(ticket);
  }
  // The reverse order restores the order of the grants in the queue.
  for (auto ticket = gone.rbegin(); ticket != gone.rend(); ++ticket) {
    const int32_t range = running_.at(*ticket).range;
    Abandoned(*ticket);
    lost_.emplace(*ticket, range);
  }
}

void RangeScheduler::CountFailure(int32_t range, RunnerId runner) {
  Range& r = ranges_[range];
  ++r.tries;
  r.failed_on.insert(runner);
  if (r.copies > 0) return;  // the other copy may still succeed
  if (FailedTooOften(r) && !poisoned_) poisoned_ = range;
}

bool RangeScheduler::FailedTooOften(const Range& range) const {
  return range.tries >= options_.max_tries || range.refusals >= options_.refused_tries ||
         (range.tries >= options_.poison_tries &&
          static_cast<int>(range.failed_on.size()) >= options_.poison_runners);
}

void RangeScheduler::Requeue(int32_t range) {
  if (ranges_[range].copies > 0) return;
  if (ranges_[range].suspect)
    suspects_.push_back(range);
  else
    queue_.push_front(range);
  ++requeued_;
}

}  // namespace slicefarm::coordinator
