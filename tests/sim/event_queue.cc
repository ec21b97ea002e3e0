#include "tests/sim/event_queue.h"

#include <algorithm>
#include <utility>

namespace slicefarm::coordinator::sim {

void EventQueue::At(int64_t at_us, Action action) {
  size_t place = actions_.size();
  if (free_.empty()) {
    actions_.push_back(std::move(action));
  } else {
    place = free_.back();
    free_.pop_back();
    actions_[place] = std::move(action);
  }
  queue_.emplace(std::max(at_us, now_us_), made_++, place);
}

bool EventQueue::Step() {
  if (queue_.empty()) return false;
  const auto [at_us, number, place] = queue_.top();
  queue_.pop();
  const Action action = std::exchange(actions_[place], nullptr);
  free_.push_back(place);
  now_us_ = at_us;
  ++steps_;
  action();
  return true;
}

void EventQueue::RunUntil(int64_t until_us) {
  while (!queue_.empty() && std::get<0>(queue_.top()) <= until_us) Step();
  now_us_ = std::max(now_us_, until_us);
}

}  // namespace slicefarm::coordinator::sim
