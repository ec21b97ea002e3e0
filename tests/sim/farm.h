#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Layers [first, last) of a job.
struct RangeOfWork {
  Work work;
  std::string build;
  int32_t first = 0;
  int32_t last = 0;
};

using RangeHashes = std::vector<uint64_t>;

/// Simulated workers, and the network between them and the coordinators.
class Farm {
 public:
  /// Function that receives the answer to a call, or the error with which the call ended. If the
  /// network doubles the answer, it is called twice.
  using Reply = std::function<void(const absl::StatusOr<RangeHashes>&)>;

  explicit Farm(World& world);

  /// Returns the number of workers.
  int workers() const { return static_cast<int>(nodes_.size()); }
  /// Returns the number of slots of a worker.
  int slots(int worker) const { return world_.scenario.workers[worker].slots; }
  /// Returns the processes that a worker supports.
  ProcessSet can(int worker) const { return world_.scenario.workers[worker].can; }

  /// Sends a range to a worker.
  void Call(int coordinator, int worker, const RangeOfWork& range, Reply reply);

  /// Returns true if the coordinator's connection to the worker seems to work. The connection
  /// detects a broken line only after a while.
  bool Reachable(int coordinator, int worker) const;

  /// Kills a worker. It restarts after `restart_after_us`.
  void Kill(int worker, int64_t restart_after_us);
  /// Pauses a worker until the time `until_us`.
  void Pause(int worker, int64_t until_us) { nodes_[worker]->process.Pause(until_us); }
  /// Breaks the line between a coordinator and a worker until the time `until_us`.
  void Partition(int coordinator, int worker, int64_t until_us);

 private:
  struct InFlight {
    Reply reply;
    int coordinator = 0;
    bool settled = false;
  };
  using Flight = std::shared_ptr<InFlight>;  // shared by the events that may answer the call

  struct Line {
    int64_t broken_since_us = 0;
    int64_t broken_until_us = 0;
  };

  struct Node {
    explicit Node(EventQueue& events) : process(events) {}
    Process process;
    std::list<Flight> flights;  ///< calls that this worker is working on
    std::vector<Line> lines;    ///< lines to the coordinators, indexed by coordinator
  };

  int64_t Delay();
  void Arrived(int worker, const Flight& flight, const RangeOfWork& range);
  void Worked(int worker, const Flight& flight, const RangeOfWork& range);
  void Answer(int worker, const Flight& flight, const absl::StatusOr<RangeHashes>& answer);
  void SendAnswer(const Flight& flight, int64_t delay_us,
                  const absl::StatusOr<RangeHashes>& answer);
  bool Broken(int coordinator, int worker) const;

  World& world_;
  std::vector<std::unique_ptr<Node>> nodes_;
  /// latest result of any worker; used as the answer for a later range if Variant::answers_mixed is
  /// set
  RangeHashes last_made_;
};

}  // namespace slicefarm::coordinator::sim
