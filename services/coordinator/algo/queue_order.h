#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// A job that a coordinator holds, and that has a place there until it ends.
struct HeldPlace {
  std::string tenant;
  std::string owner;  ///< the coordinator
  bool interactive = false;
  int64_t start_us = 0;  ///< 0: it is about to begin

  friend bool operator==(const HeldPlace&, const HeldPlace&) = default;
};

/// A job that nobody holds.
struct WaitingJob {
  int64_t number = 0;  ///< of its record
  bool interactive = false;

  friend bool operator==(const WaitingJob&, const WaitingJob&) = default;
};

/// The waiting jobs of a tenant, in the order in which they are served.
struct TenantQueue {
  std::string tenant;
  int64_t turn_us = 0;  ///< when a job of the tenant was claimed last; 0: never
  std::vector<WaitingJob> waiting = {};

  friend bool operator==(const TenantQueue&, const TenantQueue&) = default;
};

/// The open jobs of a farm at one time.
struct QueueSnapshot {
  std::vector<HeldPlace> held = {};  ///< in the order of their beginnings
  std::set<std::string> held_work =
      {};  ///< action digests that other jobs of the same work wait for
  std::vector<TenantQueue> tenants = {};  ///< by name; none without waiting jobs
  std::vector<int64_t> runs_us =
      {};  ///< times that the latest jobs took from their beginning to their end

  friend bool operator==(const QueueSnapshot&, const QueueSnapshot&) = default;
};

/// A run that is expected if no job comes, and none is cancelled.
struct ExpectedRun {
  int64_t number = 0;  ///< of the job's record
  int64_t start_us = 0;
  int64_t end_us = 0;

  friend bool operator==(const ExpectedRun&, const ExpectedRun&) = default;
};

/// Returns the mean time of the latest runs in microseconds; 0 if too few are known.
int64_t MeanRunUs(const QueueSnapshot& queue);

/// Returns the waiting jobs in the order in which the farm will begin them, as JobStore::Claim
/// chooses them: the tenant with the fewest held jobs comes first, then the one that has waited
/// longest for its turn; each coordinator keeps one place for interactive jobs. Each run is taken
/// to last as long as the mean of the latest ones, so the times are estimates, and without a mean
/// no more than an order. A place that is held for longer than that is taken to be free after as
/// long again. Cost: O(jobs * log(tenants)).
std::vector<ExpectedRun> ExpectedRuns(const QueueSnapshot& queue, int64_t now_us);

}  // namespace slicefarm::coordinator
