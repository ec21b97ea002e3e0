#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// What runs on each runner, so far as that decides what else may: a task that a runner died of
/// runs alone on its runner, and one such task at a time, so that it takes nothing else with it,
/// and the runners that are left go on. Not thread-safe.
class RunnerLoads {
 public:
  using Call = std::pair<int64_t, int64_t>;  ///< job and ticket

  void Begin(RunnerId runner, Call call, bool alone) {
    calls_[runner].insert(call);
    if (alone) lone_ = {runner, call};
  }
  /// More than once does no harm.
  void End(Call call) {
    for (auto& [runner, calls] : calls_) calls.erase(call);
    if (lone_ && lone_->second == call) lone_.reset();
  }
  void Gone(RunnerId runner) {
    calls_.erase(runner);
    if (lone_ && lone_->first == runner) lone_.reset();
  }

  /// Whether nothing may be added to what the runner has.
  bool IsTaken(RunnerId runner) const { return lone_ && lone_->first == runner; }
  /// Whether a task runs alone on any runner.
  bool AnyAlone() const { return lone_.has_value(); }
  /// Whether the runner may have a task alone.
  bool MayTakeAlone(RunnerId runner) const {
    const auto found = calls_.find(runner);
    return !lone_ && (found == calls_.end() || found->second.empty());
  }

 private:
  std::map<RunnerId, std::set<Call>> calls_;
  std::optional<std::pair<RunnerId, Call>> lone_;
};

}  // namespace slicefarm::coordinator
