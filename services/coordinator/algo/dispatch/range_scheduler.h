#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// Limits for failing and slow ranges.
struct SchedulerOptions {
  /// Number of failed tries of a range after which the job fails. Applies only if the range has
  /// failed on `poison_runners` different runners.
  int poison_tries = 3;
  /// Smallest number of different runners on which the range must have failed before `poison_tries`
  /// ends the job.
  int poison_runners = 2;
  int refused_tries = 3;  ///< number of refusals of a range (see Refused) after which the job fails
  /// Failed tries of a range after which the job fails, even if all of them were on one runner.
  int max_tries = 10;
  /// Longest wait of a suspect range for a runner that should get it first (see NextSuspect), in
  /// seconds. After this time, any idle runner may get the range.
  double elsewhere_after_s = 2;
  /// Time in seconds after which a running range counts as slow, if it has also exceeded
  /// `hedge_after_ratio`.
  double hedge_after_s = 1;
  /// Multiple of the slowest finished range's time after which a running range counts as slow, if
  /// it has also exceeded `hedge_after_s`.
  double hedge_after_ratio = 2;
  double hedge_share = 0.05;  ///< number of second copies that each finished range allows
  /// Largest number of allowed second copies that may accumulate; also their number at the start.
  double hedge_burst = 16;
};

/// Decides which range of one job runs next. A pure state machine without threads and without a
/// clock. `now_s` may come from any clock that does not run backwards.
///
/// - Ranges are granted in order. A range that failed goes to the front of the queue, preferably to
///   a runner where it has not failed.
/// - When the queue is empty, an idle runner gets a second copy of a slow range that another runner
///   has. The first result counts.
/// - A range is suspect if its runner died while it ran, until the range is done. This concerns all
///   ranges that ran on that runner at the time. A suspect range waits apart from the queue for an
///   idle runner.
/// - A range that keeps failing ends the job, by the poison rule of SchedulerOptions.
///
/// INVARIANT: a range is queued, or suspect and waiting, or running in one or two copies, or done.
/// Not thread-safe.
class RangeScheduler {
 public:
  using Ticket = int64_t;

  /// Permission for a runner to run one copy of a range.
  struct Grant {
    Ticket ticket = 0;
    int32_t range = 0;
    bool suspect = false;
  };

  /// Effect of a successful copy.
  struct Accepted {
    /// True if this is the first result of the range; otherwise the result is dropped.
    bool first = false;
    std::vector<Ticket> superfluous = {};  ///< running copies of the same range, to be cancelled
  };

  explicit RangeScheduler(int32_t range_count, const SchedulerOptions& options = {});

  /// Returns the next queued range for `runner`. Returns nullopt if the queue is empty or the job
  /// failed.
  std::optional<Grant> Next(RunnerId runner, double now_s);

  /// Returns the first suspect range that `runner` may get; nullopt if there is none. A suspect
  /// range goes first to the runner that died of it. If that try fails too, the range goes to
  /// runners that have not had it alone. After `elsewhere_after_s` of waiting it goes to any
  /// runner. REQUIRES: the runner is idle and gets no other range meanwhile.
  std::optional<Grant> NextSuspect(RunnerId runner, double now_s);

  /// Records that the runner can be reached.
  void Seen(RunnerId runner);

  /// Returns true if a suspect range waits for the runner to be reachable.
  bool Misses(RunnerId runner) const;

  /// Returns true if NextSuspect would grant a range.
  bool MayTakeSuspect(RunnerId runner, double now_s);

  /// Starts a second copy of a slow range on `runner`. Chooses the range that has run longest on
  /// another runner. Returns nullopt if no range is slow. Skips ranges that have reached the limit
  /// of failed tries, because their last running copy decides about the job. REQUIRES: Queued() ==
  /// 0.
  std::optional<Grant> Hedge(RunnerId runner, double now_s);

  /// Records a result. Late results from runners that left count as well, because a range's result
  /// does not depend on the runner.
  Accepted Succeeded(Ticket ticket, double now_s);

  /// Records a failed copy. The range returns to the queue, unless it is done or another copy of it
  /// runs.
  void Failed(Ticket ticket);

  /// Records a failed copy as Failed does, and counts it as a refusal: the runner is alive and
  /// reports that it cannot make the range.
  void Refused(Ticket ticket);

  /// Records a failed copy as Failed does, and makes the range suspect: the runner or its
  /// connection died.
  void Died(Ticket ticket);

  /// Returns the range of a copy to the queue without counting a try, because the range is not the
  /// reason for the end of the call. For example, the runner drains.
  void Abandoned(Ticket ticket);

  /// Returns all ranges of the runner to the queue. Their results may still arrive.
  void RunnerGone(RunnerId runner);

  /// Returns true if all ranges are done.
  bool AllDone() const { return done_ == static_cast<int32_t>(ranges_.size()); }
  /// Returns the range that ended the job by the poison rule; nullopt if there is none.
  std::optional<int32_t> Poisoned() const { return poisoned_; }
  /// Returns the number of queued ranges.
  int32_t Queued() const { return static_cast<int32_t>(queue_.size()); }
  /// Returns the number of suspect ranges that wait.
  int32_t Suspects() const { return static_cast<int32_t>(suspects_.size()); }
  /// Returns the number of running copies.
  int32_t Running() const { return static_cast<int32_t>(running_.size()); }
  /// Returns the number of failed tries of the range.
  int Tries(int32_t range) const { return ranges_[range].tries; }
  /// Returns how often a range returned to the queue.
  int64_t Requeued() const { return requeued_; }
  /// Returns the number of second copies so far.
  int64_t Hedged() const { return hedged_; }

 private:
  struct Range {
    bool done = false;
    int copies = 0;
    int tries = 0;
    int refusals = 0;  ///< tries that ended with a refusal
    bool suspect = false;
    /// Time at which a runner was first considered for the waiting suspect range.
    std::optional<double> waits_since_s = {};
    std::set<RunnerId> failed_on = {};
    std::set<RunnerId> alone_on = {};  ///< runners that had the range alone, as a suspect
    /// Runner that last died of the range and has not been reachable since. No other runner gets
    /// the range until this runner is reachable again or `elsewhere_after_s` is over, so that no
    /// other runner dies as well.
    std::optional<RunnerId> away = {};
  };
  struct Copy {
    int32_t range = 0;
    RunnerId runner = 0;
    double since_s = 0;
  };

  Grant Start(int32_t range, RunnerId runner, double now_s);
  std::optional<Copy> Stopped(Ticket ticket);
  std::deque<int32_t>::iterator SuspectFor(RunnerId runner, double now_s);
  void Requeue(int32_t range);
  void CountFailure(int32_t range, RunnerId runner);
  bool FailedTooOften(const Range& range) const;

  SchedulerOptions options_;
  std::vector<Range> ranges_;
  std::deque<int32_t> queue_;
  std::deque<int32_t> suspects_;
  std::map<Ticket, Copy> running_;
  std::map<Ticket, int32_t> lost_;  ///< copies on runners that left; their results may still arrive
  Ticket next_ticket_ = 1;
  int32_t done_ = 0;
  double slowest_done_s_ = 0;
  std::optional<int32_t> poisoned_;
  int64_t requeued_ = 0;
  int64_t hedged_ = 0;
};

}  // namespace slicefarm::coordinator
