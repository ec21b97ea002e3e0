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

/// The layers [first, last) of a job.
struct RangeOfWork {
  Work work;
  std::string build;
  int32_t first = 0;
  int32_t last = 0;
};

using RangeHashes = std::vector<uint64_t>;

/// The workers, and the network between them and the coordinators.
class Farm {
 public:
  /// Called when an answer or the end of the call arrives; again if the answer is doubled.
  using Reply = std::function<void(const absl::StatusOr<RangeHashes>&)>;

  explicit Farm(World& world);

  int workers() const { return static_cast<int>(nodes_.size()); }
  int slots(int worker) const { return world_.scenario.workers[worker].slots; }
  ProcessSet can(int worker) const { return world_.scenario.workers[worker].can; }

  /// Has a range made.
  void Call(int coordinator, int worker, const RangeOfWork& range, Reply reply);

  /// As the connection has it: a broken line is noticed only after a while.
  bool Reachable(int coordinator, int worker) const;

  void Kill(int worker, int64_t restart_after_us);
  void Pause(int worker, int64_t until_us) { nodes_[worker]->process.Pause(until_us); }
  void Partition(int coordinator, int worker, int64_t until_us);

 private:
  struct InFlight {
    Reply reply;
    int coordinator = 0;
    bool settled = false;
  };
  using Flight = std::shared_ptr<InFlight>;  // shared by the events that may settle it

  struct Line {
    int64_t broken_since_us = 0;
    int64_t broken_until_us = 0;
  };

  struct Node {
    explicit Node(EventQueue& events) : process(events) {}
    Process process;
    std::list<Flight> flights;  ///< that it works on
    std::vector<Line> lines;    ///< by coordinator
  };

  int64_t Delay();
  void Arrived(int worker, const Flight& flight, const RangeOfWork& range);
  void Worked(int worker, const Flight& flight, const RangeOfWork& range);
  void Answer(int worker, const Flight& flight, const absl::StatusOr<RangeHashes>& answer);
  void Settle(const Flight& flight, int64_t delay_us, const absl::StatusOr<RangeHashes>& answer);
  bool Broken(int coordinator, int worker) const;

  World& world_;
  std::vector<std::unique_ptr<Node>> nodes_;
  RangeHashes last_made_;  ///< for answers that are mixed up
};

}  // namespace slicefarm::coordinator::sim
