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

/// Differences between the simulated and the real farm: deliberate flaws, with which tests show
/// that the simulation finds them, or a second store for a comparison.
struct Variant {
  /// Wraps the store in memory (second argument) and returns the store that the coordinators call.
  /// Empty: they call the store in memory.
  std::function<std::unique_ptr<JobStore>(World&, JobStore&)> store = {};
  SchedulerOptions scheduler = {};
  /// SweepOptions::keep_blobs_s. Must be longer than the longest time from the use of a blob to the
  /// record that refers to it.
  double keep_blobs_s = 90;
  bool answers_mixed = false;        ///< true: workers answer with the layers of another range
  bool every_answer_counts = false;  ///< true: all answers of a range count, not only the first
  bool failures_unreported = false;  ///< true: failures of ranges are not passed to FanOut
  /// true: the processes that workers can make are not passed to FanOut
  bool processes_unreported = false;
  bool cancels_unread = false;    ///< true: a claim ignores the job's cancel request
  bool deadlines_unread = false;  ///< true: a claim ignores the job's deadline
  /// true: suspected jobs (lost_runs.h) begin as if all coordinators were calm
  bool calm_unasked = false;
};

/// Planned actions of a client.
struct ClientPlan {
  std::string tenant;
  std::string request_id;  ///< empty: creates the job with a single call and accepts any answer
  Work work;
  Priority priority = Priority::kNormal;
  bool yesterday = false;  ///< true if the client's job ended before the simulation begins
  int64_t begin_us = 0;
  std::optional<int64_t> deadline_us;  ///< time from begin_us to the job's deadline
  /// time from the acknowledgement of the job to the client's cancel request
  std::optional<int64_t> cancel_after_us;
  bool deletes = false;  ///< true if the client deletes its job after the job's end
};

/// Build and clock of a coordinator.
struct CoordinatorPlan {
  std::string build;
  int64_t skew_us = 0;  ///< difference of the coordinator's clock from the correct time
};

/// Properties of a worker.
struct WorkerPlan {
  int slots = 1;
  int slowness = 1;
  ProcessSet can = ProcessSet::All();  ///< processes that the worker supports
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
  std::vector<Fault> faults;                  ///< kinds of faults that may happen in this scenario
  int64_t fault_every_us = kSecondUs;         ///< average interval of faults
  int64_t quiet_from_us = 20 * kSecondUs;     ///< time after which no faults happen
  int64_t max_open = INT64_MAX;               ///< largest number of open jobs of a tenant
  int64_t sweep_every_us = kSecondUs;         ///< average interval of sweeps
  double keep_jobs_s = 0;
  bool changes_told = true;  ///< true if the store notifies all coordinators of changes
  int lost_permille = 0;     ///< lost messages per thousand
  int doubled_permille = 0;
  int store_fault_permille = 0;   ///< failing store calls per thousand
  int worker_fault_permille = 0;  ///< failing ranges per thousand
};

/// Returns a random scenario.
Scenario MakeScenario(Random& random);

}  // namespace slicefarm::coordinator::sim
