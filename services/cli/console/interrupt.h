#pragma once

#include <atomic>
#include <thread>

#include "common/base/cancel_token.h"

namespace slicefarm::cli {

/// Ends the program at Ctrl-C (SIGINT) or SIGTERM. The first signal sets a request, and the program
/// ends by itself. If it has not ended 0.3 seconds later, it is ended wherever it is. The second
/// signal ends it at once. In every case the exit code is kCancelled, and no partial file is left
/// (files.h).
///
/// Create this object first in main, before any other thread, because it blocks the signals for all
/// threads.
class Interrupt {
 public:
  /// Blocks the signals and starts the thread that waits for them.
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Removes the time limit after the first signal, because the program has to notify a server.
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
