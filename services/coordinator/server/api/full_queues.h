#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/status.h"

namespace slicefarm::coordinator {

/// Tenants whose queue was full a moment ago, so that their meshes are not taken in for jobs that
/// would be refused: at twice what a farm can do, half of its work was that. Thread-safe.
class FullQueues {
 public:
  /// `now_us`: of a clock that never runs backwards.
  explicit FullQueues(std::function<int64_t()> now_us) : now_us_(std::move(now_us)) {}

  /// What became of a job of the tenant, who may have `max_open` that have not ended.
  void Note(const std::string& tenant, const absl::Status& created, int64_t max_open);

  /// Errors: the last refusal, until a job is taken again, and for no longer than it is likely to
  /// hold: a second, or less where a queue is so short that it might be empty by then.
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
