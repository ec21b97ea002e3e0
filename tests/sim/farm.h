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
  /// Function that is called when an answer or the end of the call arrives. It is called twice if
  /// the answer is doubled.
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

  /// Returns true if the connection considers the worker reachable. It detects a broken line only
  /// after a while.
  bool Reachable(int coordinator, int worker) const;

  /// Kills a worker, which restarts after this time.
  void Kill(int worker, int64_t restart_after_us);
  /// Pauses a worker until this time.
  void Pause(int worker, int64_t until_us) { nodes_[worker]->process.Pause(until_us); }
  /// Breaks the line between a coordinator and a worker until this time.
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
    std::list<Flight> flights;  ///< calls that it is working on
    std::vector<Line> lines;    ///< lines by coordinator
  };

  int64_t Delay();
  void Arrived(int worker, const Flight& flight, const RangeOfWork& range);
  void Worked(int worker, const Flight& flight, const RangeOfWork& range);
  void Answer(int worker, const Flight& flight, const absl::StatusOr<RangeHashes>& answer);
  void DeriveOptions(const Flight& flight, int64_t delay_us,
                     const absl::StatusOr<RangeHashes>& answer);
  bool Broken(int coordinator, int worker) const;

  World& world_;
  std::vector<std::unique_ptr<Node>> nodes_;
  RangeHashes last_made_;  ///< result of the last range, for mixed-up answers
};

}  // namespace slicefarm::coordinator::sim
