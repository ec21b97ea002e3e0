#pragma once

#include <chrono>
#include <csignal>

namespace slicefarm::rpc {

/// SIGTERM and SIGINT as an event to wait for. Construct it in main() before the first thread
/// starts: it blocks the signals in this thread, and threads inherit that.
class ShutdownSignal {
 public:
  ShutdownSignal();

  /// Blocks until one of the signals comes; returns its number.
  int Wait() const;

  /// False: none came for so long.
  bool WaitFor(std::chrono::milliseconds time) const;

 private:
  sigset_t signals_;
};

}  // namespace slicefarm::rpc
