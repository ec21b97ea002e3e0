#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/run/lease_table.h"
#include "tests/sim/checked_store.h"
#include "tests/sim/sim_run.h"

namespace slicefarm::coordinator::sim {

/// Returns the job that a coordinator of this build creates for a client.
NewJob MakeJob(const ClientPlan& client, const std::string& job_id, const std::string& build);

/// Answer to a client.
struct Reply {
  JobRecord job = {};
  std::vector<JobEventRecord> events = {};
};
using ReplyTo = std::function<void(const absl::StatusOr<Reply>&)>;

/// Simulated coordinator: JobRunner and JobsService without threads. Claims jobs, renews their
/// leases, runs them and answers clients. It can be killed, stopped, paused and started again.
class SimCoordinator {
 public:
  SimCoordinator(World& world, CheckedStore& store, Farm& farm, int index);

  /// Starts the coordinator.
  void Start();
  /// Kills the coordinator.
  void Kill();
  /// Puts all running jobs back into the queue, ends, and starts again.
  void Stop();
  /// Pauses the coordinator until the time `until_us`.
  void Pause(int64_t until_us) { process_.Pause(until_us); }

  /// Returns the process of the coordinator.
  Process& process() { return process_; }
  /// Returns the dispatcher of the coordinator.
  SimDispatcher& dispatcher() { return dispatcher_; }
  /// Returns true if the coordinator answers calls.
  bool Serving() const { return process_.up() && leases_ && !stopping_; }

  /// Creates a job for a client.
  void Create(const ClientPlan& client, const std::string& job_id, const ReplyTo& reply);
  /// Requests the end of a job.
  void Cancel(const std::string& job_id, const ReplyTo& reply);
  /// Deletes an ended job.
  void Delete(const std::string& job_id, const ReplyTo& reply);
  /// Returns the events of a job with a sequence above `after`.
  void Events(const std::string& job_id, int64_t after, const ReplyTo& reply);

  /// Handles the notice of a shared store that a job has changed. nullopt: notices may have been
  /// lost, so any job may have changed.
  void Changed(const std::optional<JobChange>& change);

 private:
  /// Simulated thread that runs jobs.
  struct Slot {
    bool idle = false;
    int64_t naps = 0;  ///< number of the current sleep, to distinguish it from earlier sleeps
  };
  using Claimed = absl::StatusOr<std::optional<JobRecord>>;

  void Released(const absl::Status& released);
  void Wake();
  void Serve(int slot);
  void NextClaim();
  void Claim(int slot);
  void Take(int slot, int64_t claimed_us, int64_t seen, const Claimed& claimed);
  void Adopt(int slot, int64_t claimed_us, JobRecord job);
  void PutBack(int slot, const Lease& lease);
  void Run(int slot, int64_t claimed_us, const JobRecord& job);
  void Nap(int slot, int64_t seen);
  void Keep();
  void EndOverdue();
  void CheckHeard(const SimRun& run);
  void CheckGivenUp(const SimRun& run);
  void SweepFromTimeToTime();
  void Notice();
  void Die();
  void EndIfStopped();
  std::string Owner() const { return "c" + std::to_string(index_); }
  int64_t NowUs() const { return world_.wall_us() + plan_.skew_us; }

  World& world_;
  CheckedStore& store_;
  const int index_;
  const CoordinatorPlan plan_;
  Process process_;
  StoreLink link_;
  SimDispatcher dispatcher_;
  RunDesk desk_;
  std::map<int64_t, Work> works_;  ///< works by Work::id; the id is also the spec of the work's job

  // State of the current life:
  std::optional<LeaseTable> leases_;
  int64_t calm_since_us_ = 0;
  std::map<Lease, std::shared_ptr<SimRun>> runs_;
  /// Fact that a run should have learned at the last renewal of its lease, by lease; empty: none.
  /// If the run has not learned the fact at the next renewal, this is a violation.
  std::map<Lease, std::string> unheard_;
  std::vector<Slot> slots_;
  /// Threads that wait to claim; only one claims at a time, as with claim_mutex_ of JobRunner.
  std::vector<int> claims_wanted_;
  bool claiming_ = false;
  int64_t wakes_ = 0;
  bool stopping_ = false;
};

}  // namespace slicefarm::coordinator::sim
