#pragma once

#include <chrono>
#include <csignal>

namespace slicefarm::rpc {

/// SIGTERM and SIGINT as an event to wait for. Construct it in main() before the first thread
/// starts: it blocks the signals in this thread, and new threads inherit this.
class ShutdownSignal {
 public:
  ShutdownSignal();

  /// Blocks until one of the signals arrives; returns its number.
  int Wait() const;

  /// Waits for at most `time`. Returns false if no signal arrived.
  bool WaitFor(std::chrono::milliseconds time) const;

 private:
  sigset_t signals_;
};

}  // namespace slicefarm::rpc
