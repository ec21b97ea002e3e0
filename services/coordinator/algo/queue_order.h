#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// Job that a coordinator holds. It occupies a slot there until it ends.
struct HeldPlace {
  std::string tenant;
  std::string owner;  ///< name of the coordinator
  bool interactive = false;
  int64_t start_us = 0;  ///< 0 if the job has not begun yet

  friend bool operator==(const HeldPlace&, const HeldPlace&) = default;
};

/// Job that no coordinator holds.
struct WaitingJob {
  int64_t number = 0;  ///< number of the job's record
  bool interactive = false;

  friend bool operator==(const WaitingJob&, const WaitingJob&) = default;
};

/// Waiting jobs of a tenant, in the order in which they begin.
struct TenantQueue {
  std::string tenant;
  int64_t turn_us = 0;  ///< time of the last claim of a job of this tenant; 0 if there was none
  std::vector<WaitingJob> waiting = {};

  friend bool operator==(const TenantQueue&, const TenantQueue&) = default;
};

/// Open jobs of a farm at one time.
struct QueueSnapshot {
  std::vector<HeldPlace> held = {};  ///< held jobs in the order of their begin
  /// Action digests of the held work for which other jobs wait.
  std::set<std::string> held_work = {};
  std::vector<TenantQueue> tenants = {};  ///< tenants with waiting jobs, sorted by name
  std::vector<int64_t> runs_us = {};      ///< run times of the latest jobs

  friend bool operator==(const QueueSnapshot&, const QueueSnapshot&) = default;
};

/// Expected run of a job if no new job arrives and none is cancelled.
struct ExpectedRun {
  int64_t number = 0;  ///< number of the job's record
  int64_t start_us = 0;
  int64_t end_us = 0;

  friend bool operator==(const ExpectedRun&, const ExpectedRun&) = default;
};

/// Returns the mean time of the latest runs in microseconds; 0 if there are too few.
int64_t MeanRunUs(const QueueSnapshot& queue);

/// Returns the waiting jobs in the order in which JobStore::Claim will begin them. The tenant with
/// the fewest held jobs comes first, then the one that has waited longest for its turn. Each
/// coordinator reserves one slot for interactive jobs.
///
/// Each run is assumed to last as long as the mean of the latest runs, so the times are estimates.
/// Without a mean, only the order is meaningful. A job that has run longer than the mean is assumed
/// to run for the same time again. Cost: O(jobs * log(tenants)).
std::vector<ExpectedRun> ExpectedRuns(const QueueSnapshot& queue, int64_t now_us);

}  // namespace slicefarm::coordinator
