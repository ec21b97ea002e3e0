#pragma once

#include <atomic>
#include <thread>

#include "common/base/cancel_token.h"

namespace slicefarm::cli {

/// Ends the program at Ctrl-C (SIGINT) or SIGTERM. At the first signal, the token is cancelled, and
/// the program should end by itself. If it is still running 0.3 seconds later, or if a second
/// signal arrives, the program is ended at once. In all cases the exit code is kCancelled, and no
/// partial file is left (files.h).
///
/// Create this object first in main, before any other thread starts, because it blocks the signals
/// for all threads.
class Interrupt {
 public:
  /// Blocks the signals and starts the thread that waits for them.
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Removes the limit of 0.3 seconds after the first signal. For a program that must notify a
  /// server before it ends.
  void WaitForEnd() { waits_for_end_ = true; }

  bool Requested() const { return requested_; }
  /// Returns a token that is cancelled by the first signal.
  CancelToken Token() const;

 private:
  void Wait();
  void AwaitEnd() const;

  std::atomic<bool> waits_for_end_ = false;
  std::atomic<bool> requested_ = false;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::cli
