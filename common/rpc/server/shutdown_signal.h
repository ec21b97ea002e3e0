#pragma once

#include <chrono>
#include <csignal>

namespace slicefarm::rpc {

/// Waits for SIGTERM and SIGINT. Construct the object in main() before the first thread starts. The
/// constructor blocks both signals in the main thread, and all threads that are started later
/// inherit the block.
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
