#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/sim/sim_coordinator.h"

namespace slicefarm::coordinator::sim {

using Coordinators = std::vector<std::unique_ptr<SimCoordinator>>;

/// Simulated client. It creates a job and repeats the call until a coordinator acknowledges the
/// job. It watches the job by the numbers of its events. It may cancel or delete the job. Each call
/// goes to a random coordinator. The client uploads its mesh if a coordinator reports that the mesh
/// is missing.
class SimClient {
 public:
  SimClient(World& world, CheckedStore& store, Coordinators& coordinators, int index);

  /// Starts the client, which first creates its job.
  void Start();
  /// Starts the client with a job that ended before the simulation.
  void StartFromYesterday(const std::string& job_id);
  /// Returns true if the client has completed its plan.
  bool done() const { return done_; }

 private:
  using Call = std::function<void(SimCoordinator& to, const ReplyTo& reply)>;

  void Send(const Call& call, const ReplyTo& then);
  void Arrive(SimCoordinator& to, int64_t delay_us, const Call& call, const ReplyTo& settle);
  void Create();
  void NotCreated(const absl::Status& error);
  void Created(const std::string& job_id);
  void Cancel();
  void Watch();
  void Watched(const std::vector<JobEventRecord>& events);
  void Ended(JobState state);
  void Delete();
  void Again(void (SimClient::*what)());

  World& world_;
  CheckedStore& store_;
  Coordinators& coordinators_;
  const int index_;
  const ClientPlan plan_;
  std::string job_id_;
  int64_t seen_ = 0;  ///< number of the last event that the client has received
  int tries_ = 0;
  bool cancelling_ = false;
  bool done_ = false;
};

}  // namespace slicefarm::coordinator::sim
