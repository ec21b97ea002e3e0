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

/// Connections to one coordinator, which calls take in turn. Thread-safe.
class Farm {
 public:
  /// The one place where the generator opens channels. Each has a connection of its own, since a
  /// server lets one have only so many calls open, and none repeats a call by itself: what fails
  /// is to show. Errors: UNAVAILABLE if the server does not answer within `patience`.
  /// Also those of rpc::Secured.
  static absl::StatusOr<std::unique_ptr<Farm>> Connect(const std::string& server,
                                                       const rpc::ClientSecurity& security,
                                                       int connections,
                                                       std::chrono::milliseconds patience);

  FarmCalls& Next() { return *calls_[next_++ % calls_.size()]; }

 private:
  explicit Farm(std::vector<std::unique_ptr<FarmCalls>> calls) : calls_(std::move(calls)) {}

  std::vector<std::unique_ptr<FarmCalls>> calls_;
  std::atomic<uint64_t> next_ = 0;
};

}  // namespace slicefarm::load
