#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace slicefarm::coordinator::sim {

/// What is going to happen, on a clock that stands still in between. Events of the same time happen
/// in the order they were made. An event may itself let time pass: RunUntil.
class EventQueue {
 public:
  using Action = std::function<void()>;

  int64_t now_us() const { return now_us_; }
  double now_s() const { return static_cast<double>(now_us_) * 1e-6; }
  int64_t steps() const { return steps_; }

  void At(int64_t at_us, Action action);
  void After(int64_t delay_us, Action action) { At(now_us_ + delay_us, std::move(action)); }

  /// The next event happens; false: there is none.
  bool Step();

  /// Everything up to then happens.
  void RunUntil(int64_t until_us);

 private:
  using Entry = std::tuple<int64_t, int64_t, size_t>;  // time, number, place of the action

  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<Action> actions_;
  std::vector<size_t> free_;
  int64_t now_us_ = 0;
  int64_t made_ = 0;
  int64_t steps_ = 0;
};

}  // namespace slicefarm::coordinator::sim
