#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace slicefarm::coordinator::sim {

/// Queue of future events on a simulated clock, which stands still between the events. Events of
/// the same time happen in the order of their creation. An event may itself advance the clock with
/// RunUntil.
class EventQueue {
 public:
  using Action = std::function<void()>;

  /// Returns the current time.
  int64_t now_us() const { return now_us_; }
  /// Returns the current time in seconds.
  double now_s() const { return static_cast<double>(now_us_) * 1e-6; }
  /// Returns the number of events so far.
  int64_t steps() const { return steps_; }

  /// Adds an event at the time `at_us` of the simulated clock.
  void At(int64_t at_us, Action action);
  /// Adds an event `delay_us` after the current time.
  void After(int64_t delay_us, Action action) { At(now_us_ + delay_us, std::move(action)); }

  /// Runs the next event. Returns false if there is none.
  bool Step();

  /// Runs all events up to `until_us`, and sets the clock to this time.
  void RunUntil(int64_t until_us);

 private:
  using Entry = std::tuple<int64_t, int64_t, size_t>;  // time, number, index of the action

  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<Action> actions_;
  std::vector<size_t> free_;
  int64_t now_us_ = 0;
  int64_t made_ = 0;
  int64_t steps_ = 0;
};

}  // namespace slicefarm::coordinator::sim
