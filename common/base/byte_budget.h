#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <utility>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"

namespace slicefarm {

/// Limit on the number of bytes that all users of one purpose have in memory at the same time.
/// Thread-safe; must outlive its shares.
class ByteBudget {
 public:
  /// Bytes taken from the budget. The destructor returns the bytes to the budget.
  class Share {
   public:
    Share(ByteBudget& budget, int64_t bytes) : budget_(&budget), bytes_(bytes) {}
    Share(Share&& other) noexcept
        : budget_(std::exchange(other.budget_, nullptr)), bytes_(other.bytes_) {}
    Share& operator=(Share&&) = delete;
    ~Share();

   private:
    ByteBudget* budget_;
    int64_t bytes_;
  };

  explicit ByteBudget(int64_t limit) : limit_(limit) {}

  /// Takes `bytes` from the budget. Waits until all shares together are within the limit. Waiting
  /// calls are served in the order in which they were made. A share larger than the limit is
  /// granted when no other share exists. Errors: CANCELLED if `cancel` is cancelled during the
  /// wait.
  absl::StatusOr<Share> Take(int64_t bytes, const CancelToken& cancel);

  int64_t limit() const { return limit_; }

 private:
  void GiveBack(int64_t bytes);

  const int64_t limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int64_t used_ = 0;
  int64_t next_turn_ = 0;
  /// sequence numbers of the waiting calls; the smallest is served next
  std::set<int64_t> waiting_;
};

}  // namespace slicefarm
