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

/// Dispatcher without threads: slots that ask FanOut for a range, have a worker make it, and tell
/// what came of it. Watches that no range has more copies than it may, and that the poison rule is
/// kept to the letter.
class SimDispatcher {
 public:
  using Progress = std::function<void(int32_t layers_done)>;
  using Done = std::function<void(absl::StatusOr<RangeHashes> layers)>;

  SimDispatcher(World& world, Process& process, Farm& farm, int coordinator)
      : world_(world), process_(process), farm_(farm), coordinator_(coordinator) {}

  /// A new life of the coordinator begins: all workers join.
  void Begin();
  /// A life ends; what its ranges came to is counted.
  void End();

  /// Cuts the work into ranges and runs them; `done` is called once, unless it is given up.
  FanOut::JobId Execute(const Work& work, const std::string& build, Progress progress, Done done);
  void GiveUp(FanOut::JobId job);

  /// The worker's address has gone from DNS, or is there again.
  void Leave(int worker);
  void Join(int worker);

 private:
  struct Range {
    int32_t first = 0;
    int32_t last = 0;
    bool done = false;
    RangeHashes layers = {};
    std::vector<RunnerId> failed_on = {};
    int refusals = 0;  ///< of these
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
    bool stopped = false;  ///< nobody waits for it any more; its answer may be on its way
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
  std::list<Slot> slots_;  ///< those of workers that left included
  std::map<int64_t, Call> calls_;
  RunnerId next_runner_ = 1;
  int64_t next_call_ = 1;
};

}  // namespace slicefarm::coordinator::sim
