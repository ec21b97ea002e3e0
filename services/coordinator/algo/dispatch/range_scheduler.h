#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

struct SchedulerOptions {
  int poison_tries = 3;          ///< a range that failed this often ...
  int poison_runners = 2;        ///< ... on this many runners fails the job,
  int refused_tries = 3;         ///< and so does one that runners refused this often,
  int max_tries = 10;            ///< and one that failed this often, on however many runners
  double elsewhere_after_s = 2;  ///< what a runner died of waits this long for that one to be back
  double hedge_after_s = 1;      ///< a range is slow when it runs longer than this ...
  double hedge_after_ratio = 2;  ///< ... and than this many times the slowest range that is done
  double hedge_share = 0.05;     ///< second copies, as a part of the ranges that are done,
  double hedge_burst = 16;       ///< and how many more there may be at once
};

/// What is to be done next with the ranges of one job: a pure state machine. It has no threads and
/// no clock; `now_s` comes from outside, on any clock that does not run backwards.
///
///   - Ranges are granted in order; one that failed goes to the front, and rather to a runner where
///   it did not fail.
///   - When the queue is empty, a runner with nothing to do gets a second copy of a slow range that
///   another one runs.
///     The first answer wins.
///   - A range that a runner died of is suspect: it waits beside the queue, for a runner that has
///   nothing else to do. Those that ran on that runner with it are so, too, until they are done.
///   - A range that keeps failing ends the job, by the poison rule of SchedulerOptions.
///
/// INVARIANT: a range is queued, or suspect and waiting, or running in one or two copies, or done.
/// Not thread-safe.
class RangeScheduler {
 public:
  using Ticket = int64_t;

  struct Grant {
    Ticket ticket = 0;
    int32_t range = 0;
    bool suspect = false;
  };

  struct Accepted {
    bool first = false;                    ///< this is the range's result; otherwise drop it
    std::vector<Ticket> superfluous = {};  ///< running copies of the same range, to be cancelled
  };

  explicit RangeScheduler(int32_t range_count, const SchedulerOptions& options = {});

  /// The next range from the queue for `runner`; nullopt: nothing queued, or the job failed.
  std::optional<Grant> Next(RunnerId runner, double now_s);

  /// The first suspect range, for a runner that has nothing else to do, and gets nothing else
  /// meanwhile. It goes to the runner that died of it, then, when that is back, to others, or after
  /// a while to any.
  std::optional<Grant> NextSuspect(RunnerId runner, double now_s);

  /// The runner can be reached.
  void Seen(RunnerId runner);

  /// Whether a suspect waits for the runner to be seen.
  bool Misses(RunnerId runner) const;

  /// Whether NextSuspect would grant one.
  bool MayTakeSuspect(RunnerId runner, double now_s);

  /// A second copy of the range that runs longest, if it is slow, runs elsewhere, and has not
  /// failed too often already. REQUIRES: Queued() == 0.
  std::optional<Grant> Hedge(RunnerId runner, double now_s);

  /// A result came. Late results, of runners that are gone, count as well: ranges are pure
  /// functions.
  Accepted Succeeded(Ticket ticket, double now_s);

  /// A copy came to nothing: back to the queue, unless another copy runs or the range is done.
  void Failed(Ticket ticket);

  /// The same, and the copy's runner lives to say that the range cannot be made.
  void Refused(Ticket ticket);

  /// The same, and the copy's runner died, or its connection: the range becomes suspect.
  void Died(Ticket ticket);

  /// A copy was given up for a reason that says nothing of the range (its runner drains): back to
  /// the queue, not counted.
  void Abandoned(Ticket ticket);

  /// All copies of the runner failed, as far as can be told from here.
  void RunnerGone(RunnerId runner);

  bool AllDone() const { return done_ == static_cast<int32_t>(ranges_.size()); }
  /// The range that the poison rule ended the job for.
  std::optional<int32_t> Poisoned() const { return poisoned_; }
  int32_t Queued() const { return static_cast<int32_t>(queue_.size()); }
  int32_t Suspects() const { return static_cast<int32_t>(suspects_.size()); }
  int32_t Running() const { return static_cast<int32_t>(running_.size()); }
  int Tries(int32_t range) const { return ranges_[range].tries; }
  int64_t Requeued() const { return requeued_; }
  int64_t Hedged() const { return hedged_; }

 private:
  struct Range {
    bool done = false;
    int copies = 0;
    int tries = 0;
    int refusals = 0;  ///< of the tries
    bool suspect = false;
    std::optional<double> waits_since_s = {};  ///< as a suspect, when that was first asked
    std::set<RunnerId> failed_on = {};
    std::set<RunnerId> alone_on = {};  ///< where it was tried as a suspect
    /// What died of it last, and has not been seen since: while that is away, no other one is to go
    /// down as well.
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
  std::map<Ticket, int32_t>
      lost_;  ///< copies of runners that are gone, whose results may still come
  Ticket next_ticket_ = 1;
  int32_t done_ = 0;
  double slowest_done_s_ = 0;
  std::optional<int32_t> poisoned_;
  int64_t requeued_ = 0;
  int64_t hedged_ = 0;
};

}  // namespace slicefarm::coordinator
