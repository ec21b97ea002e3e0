#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tests/sim/event_queue.h"

namespace slicefarm::coordinator::sim {

/// A process that can be killed, started again, and stopped for a while (SIGSTOP). What it was
/// going to do dies with it; what happens to it while it is paused, it does later.
class Process {
 public:
  explicit Process(EventQueue& events) : events_(events) {}

  bool up() const { return up_; }
  int64_t life() const { return life_; }
  bool paused() const { return events_.now_us() < paused_until_us_; }
  int64_t paused_until_us() const { return paused_until_us_; }

  void Start() { up_ = true; }
  void Kill() {
    up_ = false;
    ++life_;
    paused_until_us_ = 0;
  }
  void Pause(int64_t until_us) { paused_until_us_ = std::max(paused_until_us_, until_us); }

  /// Something that this life of the process does later.
  void After(int64_t delay_us, EventQueue::Action action) {
    events_.After(delay_us, [this, life = life_, action = std::move(action)]() mutable {
      Deliver(life, std::move(action));
    });
  }

  /// Something that is to be done by whatever life it then is: a message from outside.
  void Arrive(int64_t delay_us, EventQueue::Action action) {
    events_.After(delay_us, [this, action = std::move(action)]() mutable {
      Deliver(life_, std::move(action));
    });
  }

 private:
  void Deliver(int64_t life, EventQueue::Action action) {
    if (!up_ || life != life_) return;
    if (!paused()) return action();
    events_.At(paused_until_us_, [this, life, action = std::move(action)]() mutable {
      Deliver(life, std::move(action));
    });
  }

  EventQueue& events_;
  bool up_ = false;
  int64_t life_ = 0;
  int64_t paused_until_us_ = 0;
};

}  // namespace slicefarm::coordinator::sim
