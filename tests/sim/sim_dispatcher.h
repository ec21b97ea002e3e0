#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "services/coordinator/algo/dispatch/fan_out.h"
#include "tests/sim/farm.h"
#include "tests/sim/process.h"
#include "tests/sim/world.h"

namespace slicefarm::coordinator::sim {

/// Dispatcher without threads. Its slots take ranges from FanOut, let workers make them, and report
/// the results. Checks that no range has too many copies, and that the poison rule is followed
/// exactly.
class SimDispatcher {
 public:
  using Progress = std::function<void(int32_t layers_done)>;
  using Done = std::function<void(absl::StatusOr<RangeHashes> layers)>;

  SimDispatcher(World& world, Process& process, Farm& farm, int coordinator)
      : world_(world), process_(process), farm_(farm), coordinator_(coordinator) {}

  /// Starts the dispatcher when its coordinator starts: all workers join.
  void Begin();
  /// Ends the dispatcher when its coordinator dies or stops. Adds the counts of its ranges to the
  /// totals.
  void End();

  /// Cuts the work into ranges and runs them. Calls `done` once, unless the job is given up.
  FanOut::JobId Execute(const Work& work, const std::string& build, Progress progress, Done done);
  /// Gives up a job and stops its calls.
  void GiveUp(FanOut::JobId job);

  /// Removes a worker, because its address has disappeared from DNS.
  void Leave(int worker);
  /// Adds a worker, because its address has appeared in DNS.
  void Join(int worker);

 private:
  struct Range {
    int32_t first = 0;
    int32_t last = 0;
    bool done = false;
    RangeHashes layers = {};
    std::vector<RunnerId> failed_on = {};
    int refusals = 0;  ///< failures in `failed_on` that were refusals
  };
  struct Job {
    Work work;
    std::string build;
    Progress progress;
    Done done;
    std::vector<Range> ranges;
    int32_t layers_done = 0;
  };
  struct Slot {
    int worker = 0;
    RunnerId runner = 0;
    bool left = false;
    bool busy = false;
    bool waiting = false;
    int failures = 0;
  };
  struct Call {
    FanOut::Grant grant;
    Slot* slot = nullptr;
    /// True if no slot waits for the call any more; its answer may still arrive.
    bool stopped = false;
  };

  void WorkNews();
  void Serve(Slot& slot);
  void ServeLater(Slot& slot, int64_t delay_us);
  void Begin(Slot& slot, const FanOut::Grant& grant);
  void CheckCopies(const Slot& slot, const FanOut::Grant& grant);
  void Answered(int64_t call, const FanOut::Grant& grant,
                const absl::StatusOr<RangeHashes>& answer);
  void Accept(const FanOut::Grant& grant, const RangeHashes& layers);
  void Reject(const Slot& slot, const FanOut::Grant& grant, const absl::Status& error);
  void CheckPoison(const Range& range, FanOut::Verdict verdict, bool other_copies);
  bool OtherCopies(const FanOut::Grant& grant) const;
  template <typename Which>
  void StopCalls(const Which& which);
  void EndJob(FanOut::JobId job, absl::StatusOr<RangeHashes> layers);

  World& world_;
  Process& process_;
  Farm& farm_;
  const int coordinator_;
  std::optional<FanOut> fan_out_;
  std::map<FanOut::JobId, Job> jobs_;
  std::list<Slot> slots_;  ///< slots, including slots of workers that left
  std::map<int64_t, Call> calls_;
  RunnerId next_runner_ = 1;
  int64_t next_call_ = 1;
};

}  // namespace slicefarm::coordinator::sim
