#pragma once

#include <atomic>
#include <thread>

#include "common/base/cancel_token.h"

namespace slicefarm::cli {

/// Ends the program at Ctrl-C (SIGINT) or SIGTERM. The first signal is a request that the program
/// sees and ends by; a program that has not ended 0.3 seconds later ends then, wherever it is. The
/// second signal ends it at once. Either way the exit code is kCancelled, and no partial file is
/// left (files.h).
///
/// Made first thing in main, before any other thread: it takes the signals for itself.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Lets the program take its time after the first signal: it has to tell a server.
  void WaitForEnd() { waits_for_end_ = true; }

  bool Requested() const { return requested_; }
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
