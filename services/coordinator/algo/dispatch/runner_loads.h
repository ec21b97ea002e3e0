#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// Calls that are in progress on each runner. A task that a runner died of runs alone on its
/// runner, so that no other task dies with it. At most one runner at a time has a task that runs
/// alone, so that the remaining runners continue. Not thread-safe.
class RunnerLoads {
 public:
  using Call = std::pair<int64_t, int64_t>;  ///< job and ticket

  /// Records the start of a call. `alone`: the runner gets no other call until the call ends.
  void Begin(RunnerId runner, Call call, bool alone) {
    calls_[runner].insert(call);
    if (alone) lone_ = {runner, call};
  }
  /// Records the end of a call. A repeated End of the same call has no effect.
  void End(Call call) {
    for (auto& [runner, calls] : calls_) calls.erase(call);
    if (lone_ && lone_->second == call) lone_.reset();
  }
  /// Removes all calls of the runner.
  void Gone(RunnerId runner) {
    calls_.erase(runner);
    if (lone_ && lone_->first == runner) lone_.reset();
  }

  /// Returns true if the runner has a task that must run alone.
  bool IsTaken(RunnerId runner) const { return lone_ && lone_->first == runner; }
  /// Returns true if a task runs alone on any runner.
  bool AnyAlone() const { return lone_.has_value(); }
  /// Returns true if the runner may get a task that must run alone: the runner has no call, and no
  /// runner has a task that runs alone.
  bool MayTakeAlone(RunnerId runner) const {
    const auto found = calls_.find(runner);
    return !lone_ && (found == calls_.end() || found->second.empty());
  }

 private:
  std::map<RunnerId, std::set<Call>> calls_;
  std::optional<std::pair<RunnerId, Call>> lone_;
};

}  // namespace slicefarm::coordinator
