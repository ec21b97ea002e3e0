#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/status.h"

namespace slicefarm::coordinator {

/// Tenants with a queue of jobs that was full a moment ago. Their meshes are refused, because their
/// jobs would be refused as well. Without this check, a farm with twice the load that it can handle
/// spent half of its work on meshes of refused jobs. Thread-safe.
class FullQueues {
 public:
  /// Creates an empty set. `now_us`: a clock that never runs backwards.
  explicit FullQueues(std::function<int64_t()> now_us) : now_us_(std::move(now_us)) {}

  /// Records the outcome `created` of an attempt to create a job of the tenant. `max_open`: the
  /// largest number of open jobs of the tenant.
  void Note(const std::string& tenant, const absl::Status& created, int64_t max_open);

  /// Returns the last refusal of the tenant if it is still valid, otherwise OK. A refusal is valid
  /// for at most one second, and ends when a job is accepted again. If the queue is so short that
  /// it might be empty earlier, the refusal is valid for a shorter time.
  absl::Status Check(const std::string& tenant);

 private:
  struct Refusal {
    absl::Status status;
    int64_t until_us = 0;
  };

  const std::function<int64_t()> now_us_;
  std::mutex mutex_;
  std::map<std::string, Refusal> refusals_;
};

}  // namespace slicefarm::coordinator
