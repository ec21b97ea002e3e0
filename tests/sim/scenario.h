#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/algo/dispatch/range_scheduler.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "tests/sim/random.h"
#include "tests/sim/sim_blobs.h"
#include "tests/sim/work.h"

namespace slicefarm::coordinator::sim {

struct World;

inline constexpr int64_t kMillisecondUs = 1'000;
inline constexpr int64_t kSecondUs = 1'000'000;

/// Differences from the real farm: flaws, so that tests can show that they are found, or a second
/// store for a comparison.
struct Variant {
  /// Returns the store that the coordinators call. It wraps the store in memory.
  std::function<std::unique_ptr<JobStore>(World&, JobStore&)> store = {};
  SchedulerOptions scheduler = {};
  /// Longer than the longest time from the use of a blob to the record that refers to it.
  double keep_blobs_s = 90;
  bool answers_mixed = false;        ///< workers answer with the layers of another range
  bool every_answer_counts = false;  ///< all answers of a range count, not only the first
  bool failures_untold = false;      ///< failures of ranges are not passed to FanOut
  bool processes_untold = false;     ///< processes of workers are not passed to FanOut
  bool cancels_unread = false;       ///< a claim ignores the job's cancel request
  bool deadlines_unread = false;     ///< a claim ignores the job's deadline
  bool calm_unasked = false;         ///< suspects begin as if all coordinators were calm
};

/// Planned actions of a client.
struct ClientPlan {
  std::string tenant;
  std::string request_id;  ///< empty: creates once, for any answer
  Work work;
  Priority priority = Priority::kNormal;
  bool yesterday = false;  ///< true if its job was done before the simulation begins
  int64_t begin_us = 0;
  std::optional<int64_t> deadline_us;      ///< time after the client's begin
  std::optional<int64_t> cancel_after_us;  ///< time after its job was acknowledged
  bool deletes = false;                    ///< true if it deletes its job after the end
};

/// Build and clock of a coordinator.
struct CoordinatorPlan {
  std::string build;
  int64_t skew_us = 0;  ///< error of its clock
};

/// Properties of a worker.
struct WorkerPlan {
  int slots = 1;
  int slowness = 1;
  ProcessSet can = ProcessSet::All();  ///< processes that it supports
};

/// Faults that may happen to the farm.
enum class Fault {
  kKillCoordinator,
  kStopCoordinator,
  kPauseCoordinator,
  kKillWorker,
  kPauseWorker,
  kPartition,
  kWorkerLeaves,
  kStoreAway,
  kDiskFull,
  kSlicingAway,
};
inline constexpr int kFaults = 10;

/// Participants and faults of one seed. Each seed has its own mix of faults ("swarm testing": Groce
/// et al., ISSTA 2012), because some bugs do not appear if all faults happen at once.
struct Scenario {
  std::vector<CoordinatorPlan> coordinators;  ///< 1 to 3
  std::vector<WorkerPlan> workers;            ///< 1 to 8
  std::vector<ClientPlan> clients;            ///< 1 to 12
  std::vector<BlobKey> meshes;                ///< meshes that were uploaded long ago
  std::vector<Fault> faults;                  ///< faults that happen
  int64_t fault_every_us = kSecondUs;         ///< average interval of faults
  int64_t quiet_from_us = 20 * kSecondUs;     ///< time after which no faults happen
  int64_t max_open = INT64_MAX;               ///< largest number of open jobs of a tenant
  int64_t sweep_every_us = kSecondUs;         ///< average interval of sweeps
  double keep_jobs_s = 0;
  bool changes_told = true;  ///< true if the store notifies all coordinators of changes
  int lost_permille = 0;     ///< rate of lost messages
  int doubled_permille = 0;
  int store_fault_permille = 0;   ///< rate of failing store calls
  int worker_fault_permille = 0;  ///< rate of failing ranges
};

/// Returns a random scenario.
Scenario MakeScenario(Random& random);

}  // namespace slicefarm::coordinator::sim
