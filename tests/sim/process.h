#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "tests/sim/event_queue.h"

namespace slicefarm::coordinator::sim {

/// Process that can be killed, started again, and paused for a while (SIGSTOP). When it is killed,
/// its planned actions are dropped. Actions during a pause run after the pause.
class Process {
 public:
  explicit Process(EventQueue& events) : events_(events) {}

  /// Returns true if the process runs.
  bool up() const { return up_; }
  /// Returns the number of kills so far. It identifies the current life: the time between two
  /// kills.
  int64_t life() const { return life_; }
  /// Returns true if the process is paused.
  bool paused() const { return events_.now_us() < paused_until_us_; }
  /// Returns the end of the pause.
  int64_t paused_until_us() const { return paused_until_us_; }

  /// Starts the process.
  void Start() { up_ = true; }
  /// Kills the process.
  void Kill() {
    up_ = false;
    ++life_;
    paused_until_us_ = 0;
  }
  /// Pauses the process until the time `until_us`.
  void Pause(int64_t until_us) { paused_until_us_ = std::max(paused_until_us_, until_us); }

  /// Adds an action after a delay. The action is dropped if the process is killed before.
  void After(int64_t delay_us, EventQueue::Action action) {
    events_.After(delay_us, [this, life = life_, action = std::move(action)]() mutable {
      Deliver(life, std::move(action));
    });
  }

  /// Adds an action after a delay, such as a message from outside. The action happens if the
  /// process runs at that time, even after a restart.
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
