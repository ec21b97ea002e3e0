#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// Held job: a coordinator has claimed the job, and the claim's lease has not expired. The job
/// occupies a slot of this coordinator until the job ends.
struct HeldSlot {
  std::string tenant;
  std::string owner;  ///< name of the coordinator
  bool interactive = false;
  int64_t start_us = 0;  ///< time at which the job began; 0 if it has not begun yet

  friend bool operator==(const HeldSlot&, const HeldSlot&) = default;
};

/// Open job that no coordinator holds.
struct WaitingJob {
  int64_t number = 0;  ///< JobRecord::number of the job
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
  /// Held jobs in the order in which they began; jobs that have not begun are last.
  std::vector<HeldSlot> held = {};
  /// Action digests of the held jobs, except held jobs that are to be cancelled. A waiting job with
  /// one of these digests has the same work as a held job, and waits for it.
  std::set<std::string> held_work = {};
  std::vector<TenantQueue> tenants = {};  ///< tenants with waiting jobs, sorted by name
  std::vector<int64_t> runs_us = {};      ///< run times of the latest jobs

  friend bool operator==(const QueueSnapshot&, const QueueSnapshot&) = default;
};

/// Expected run of a job if no new job arrives and none is cancelled.
struct ExpectedRun {
  int64_t number = 0;  ///< JobRecord::number of the job
  int64_t start_us = 0;
  int64_t end_us = 0;

  friend bool operator==(const ExpectedRun&, const ExpectedRun&) = default;
};

/// Returns the mean duration of the latest runs in microseconds; 0 if there are fewer than three.
int64_t MeanRunUs(const QueueSnapshot& queue);

/// Returns the waiting jobs in the order in which JobStore::Claim will give them. The tenant with
/// the fewest held jobs comes first, then the tenant that has waited longest for its turn. Each
/// coordinator reserves one slot for interactive jobs.
///
/// The times are estimates: each run is assumed to last as long as the mean of the latest runs. A
/// job that has run longer than the mean is assumed to run for the same time again. Without a mean,
/// only the order is meaningful. Cost: O(jobs * log(tenants)).
std::vector<ExpectedRun> ExpectedRuns(const QueueSnapshot& queue, int64_t now_us);

}  // namespace slicefarm::coordinator
