#pragma once

#include <atomic>
#include <thread>

#include "common/base/cancel_token.h"

namespace slicefarm::cli {

/// Turns the first Ctrl-C (SIGINT, or SIGTERM) into a request that the program sees; the second one
/// ends it at once. Made first thing in main, before any other thread: it takes the signals for
/// itself.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool Requested() const { return requested_; }
  CancelToken Token() const;

 private:
  void Wait();

  std::atomic<bool> requested_ = false;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::cli
