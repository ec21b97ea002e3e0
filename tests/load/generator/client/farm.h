#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/rpc/client/client_security.h"
#include "tests/load/generator/client/farm_calls.h"

namespace slicefarm::load {

/// Connections to one coordinator; calls use them in turn. Thread-safe.
class Farm {
 public:
  /// Opens the channels of the generator. Each has a connection of its own, because a server limits
  /// the calls of one connection. No channel repeats a call by itself, so that failures are
  /// visible. Errors: UNAVAILABLE if the server does not answer within `patience`; errors of
  /// rpc::Secured.
  static absl::StatusOr<std::unique_ptr<Farm>> Connect(const std::string& server,
                                                       const rpc::ClientSecurity& security,
                                                       int connections,
                                                       std::chrono::milliseconds patience);

  /// Returns the next connection.
  FarmCalls& Next() { return *calls_[next_++ % calls_.size()]; }

 private:
  explicit Farm(std::vector<std::unique_ptr<FarmCalls>> calls) : calls_(std::move(calls)) {}

  std::vector<std::unique_ptr<FarmCalls>> calls_;
  std::atomic<uint64_t> next_ = 0;
};

}  // namespace slicefarm::load
