#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/coordinator/run/lease_book.h"
#include "tests/sim/checked_store.h"
#include "tests/sim/sim_run.h"

namespace slicefarm::coordinator::sim {

/// The job that a coordinator of this build makes for a client.
NewJob MakeJob(const ClientPlan& client, const std::string& job_id, const std::string& build);

/// What a client gets back.
struct Reply {
  JobRecord job = {};
  std::vector<JobEventRecord> events = {};
};
using ReplyTo = std::function<void(const absl::StatusOr<Reply>&)>;

/// JobRunner and JobsService without threads: claims jobs, holds their leases, runs them, answers
/// clients; is killed, stopped, paused and started again.
class SimCoordinator {
 public:
  SimCoordinator(World& world, CheckedStore& store, Farm& farm, int index);

  void Start();
  void Kill();
  /// Hands everything back, ends, and starts again.
  void Stop();
  void Pause(int64_t until_us) { process_.Pause(until_us); }

  Process& process() { return process_; }
  SimDispatcher& dispatcher() { return dispatcher_; }
  bool Serving() const { return process_.up() && leases_ && !stopping_; }

  void Create(const ClientPlan& client, const std::string& job_id, const ReplyTo& reply);
  void Cancel(const std::string& job_id, const ReplyTo& reply);
  void Delete(const std::string& job_id, const ReplyTo& reply);
  void Events(const std::string& job_id, int64_t after, const ReplyTo& reply);

  /// A coordinator wrote to a job; none: changes may have been missed.
  void Changed(const std::optional<JobChange>& change);

 private:
  /// One of the threads that run jobs.
  struct Place {
    bool idle = false;
    int64_t naps = 0;  ///< tells one nap from another
  };
  using Claimed = absl::StatusOr<std::optional<JobRecord>>;

  void Released(const absl::Status& released);
  void Wake();
  void Serve(int place);
  void NextClaim();
  void Claim(int place);
  void Take(int place, int64_t claimed_us, int64_t seen, const Claimed& claimed);
  void Adopt(int place, int64_t claimed_us, JobRecord job);
  void PutBack(int place, const Lease& lease);
  void Run(int place, int64_t claimed_us, const JobRecord& job);
  void Nap(int place, int64_t seen);
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
  std::map<int64_t, Work> works_;  ///< by id: what a spec means

  // Of this life.
  std::optional<LeaseBook> leases_;
  int64_t calm_since_us_ = 0;
  std::map<Lease, std::shared_ptr<SimRun>> runs_;
  std::map<Lease, std::string> unheard_;  ///< what a run could have heard at the last renewal
  std::vector<Place> places_;
  std::vector<int> claims_wanted_;  ///< one claim at a time, as claim_mutex_ of JobRunner sees to
  bool claiming_ = false;
  int64_t wakes_ = 0;
  bool stopping_ = false;
};

}  // namespace slicefarm::coordinator::sim
