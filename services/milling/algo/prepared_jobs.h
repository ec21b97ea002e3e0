#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/milling/mill_input.h"
#include "services/milling/algo/strategy/milling_job.h"

namespace slicefarm::milling {

/// Jobs that are checked and laid out, by mesh and options: the calls for the ranges of a job find
/// it ready. Safe to call from many threads.
class PreparedJobs {
 public:
  /// Keeps as many of those that were asked for last as fit in so many bytes, and the very last.
  explicit PreparedJobs(int64_t most_bytes) : most_bytes_(most_bytes) {}

  /// Prepares it (PrepareMilling), or hands out the one that is there. Of calls that want the same
  /// one at once, one prepares it. REQUIRES: the digest is that of the meshes. Errors: those of
  /// PrepareMilling, which are not kept.
  absl::StatusOr<std::shared_ptr<const MillingJob>> Get(const MillInput& input,
                                                        const CancelToken& cancel);

  int64_t bytes() const;  ///< held now

 private:
  struct Entry {
    std::string digest;
    MillingOptions how;
    int64_t bytes = 0;  ///< guarded by mutex_
    std::mutex making;  ///< guards `job`
    std::shared_ptr<const MillingJob> job;
  };

  std::shared_ptr<Entry> Find(const MillInput& input);
  void Made(const std::shared_ptr<Entry>& entry, int64_t bytes);

  const int64_t most_bytes_;
  mutable std::mutex mutex_;
  std::list<std::shared_ptr<Entry>> entries_;  ///< the last asked for first
};

}  // namespace slicefarm::milling
