#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/coordinator/algo/dispatch/range_scheduler.h"
#include "tests/sim/random.h"
#include "tests/sim/sim_blobs.h"
#include "tests/sim/work.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator::sim {

struct World;

inline constexpr int64_t kMillisecondUs = 1'000;
inline constexpr int64_t kSecondUs = 1'000'000;

/// What is other than in the farm as it is: flaws, so that a test can show that they are found, or
/// a further store, to compare it.
struct Variant {
  /// What the coordinators call instead of the store in memory, over which it works.
  std::function<std::unique_ptr<JobStore>(World&, JobStore&)> store = {};
  SchedulerOptions scheduler = {};
  /// Longer than anything takes from the use of a blob to the record that refers to it.
  double keep_blobs_s = 90;
  bool answers_mixed = false;        ///< workers answer with the layers of another range
  bool every_answer_counts = false;  ///< of a range, not only the first
  bool failures_untold = false;      ///< FanOut is not told that a range failed
  bool processes_untold = false;     ///< FanOut is not told what a worker can run
  bool cancels_unread = false;       ///< who claims a job does not look whether it is to end
  bool deadlines_unread = false;     ///< nor by when
  bool calm_unasked = false;         ///< suspects begin as if all coordinators were calm
};

/// What a client is going to want.
struct ClientPlan {
  std::string tenant;
  std::string request_id;  ///< empty: creates once, whatever the answer
  Work work;
  Priority priority = Priority::kNormal;
  bool yesterday = false;  ///< its job was made and done before it all begins
  int64_t begin_us = 0;
  std::optional<int64_t> deadline_us;      ///< from its beginning
  std::optional<int64_t> cancel_after_us;  ///< its job was acknowledged
  bool deletes = false;                    ///< its job when that has ended
};

struct CoordinatorPlan {
  std::string build;
  int64_t skew_us = 0;  ///< of its clock
};

struct WorkerPlan {
  int slots = 1;
  int slowness = 1;
  ProcessSet can = ProcessSet::All();  ///< whose tasks it runs
};

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

/// The cast and the weather of one seed. Each seed has its own mix of faults ("swarm testing":
/// Groce et al., ISSTA 2012), as some bugs hide where everything goes wrong at once.
struct Scenario {
  std::vector<CoordinatorPlan> coordinators;  ///< 1 to 3
  std::vector<WorkerPlan> workers;            ///< 1 to 8
  std::vector<ClientPlan> clients;            ///< 1 to 12
  std::vector<BlobKey> meshes;                ///< that were uploaded long ago
  std::vector<Fault> faults;                  ///< that happen
  int64_t fault_every_us = kSecondUs;         ///< on average
  int64_t quiet_from_us = 20 * kSecondUs;     ///< then nothing goes wrong any more
  int64_t max_open = INT64_MAX;               ///< jobs of a tenant
  int64_t sweep_every_us = kSecondUs;         ///< on average
  double keep_jobs_s = 0;
  bool changes_told = true;  ///< by the store, to those who share it
  int lost_permille = 0;     ///< of messages
  int doubled_permille = 0;
  int store_fault_permille = 0;   ///< of calls of the store
  int worker_fault_permille = 0;  ///< of ranges
};

Scenario MakeScenario(Random& random);

}  // namespace slicefarm::coordinator::sim
