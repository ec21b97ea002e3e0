#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/stage/job_memory.h"
#include "common/stage/stage_call.h"
#include "common/stage/stages.h"

namespace slicefarm {

/// Limit on the memory of all jobs of this program together.
///
/// A new job waits until its memory fits beside the memory of the running jobs. Waiting jobs have
/// this order: first the tenant that uses the least memory, then the highest priority, then the
/// longest wait. A job that fits may overtake earlier jobs that do not fit. This ends when the
/// overtaking jobs have used as much memory as the whole budget.
///
/// A running job may need more memory. If several such jobs do not fit, one of them waits, and the
/// job that began last ends with OVERLOADED to free memory. The budget remembers twice the memory
/// that the ended job needed. A retry of this job waits for this amount before it begins.
///
/// Thread-safe; must outlive its shares.
class MemoryBudget {
 public:
  /// Memory of one job. The destructor returns the memory to the budget. Only one thread may use a
  /// share at a time.
  class Share final : public JobMemory {
   public:
    ~Share() override;
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;

    absl::Status Hold(Kind kind, int64_t bytes) override;

   private:
    friend class MemoryBudget;
    Share(MemoryBudget& budget, Claimant who, std::string job, CancelToken cancel)
        : budget_(budget), who_(std::move(who)), job_(std::move(job)), cancel_(std::move(cancel)) {}

    MemoryBudget& budget_;
    const Claimant who_;
    const std::string job_;
    const CancelToken cancel_;
    std::array<int64_t, kKinds> held_ = {};
    // The following members are protected by the budget's mutex.
    int64_t turn_ = 0;
    int64_t bytes_ = 0;  ///< reserved bytes: at least the used bytes
    bool yields_ = false;
    bool freed_memory_ = false;
  };

  explicit MemoryBudget(int64_t limit) : limit_(limit) {}

  /// Waits until there is memory for a new job: `bytes` for meshes, and the additional memory that
  /// an earlier attempt of the job needed. `job`: the job's id. `cancel`: ends this wait and the
  /// waits of Share::Hold. Errors: REQUEST_TOO_LARGE if the job does not fit even without other
  /// jobs; CANCELLED.
  absl::StatusOr<std::unique_ptr<Share>> Take(const Claimant& who, const std::string& job,
                                              int64_t bytes, const CancelToken& cancel);

  int64_t limit() const { return limit_; }
  int64_t used() const;

 private:
  using Lock = std::unique_lock<std::mutex>;
  struct Waiter {
    Claimant who;
    int64_t bytes = 0;
    int64_t turn = 0;
    int64_t passed_by = 0;  ///< total bytes of the jobs that have overtaken this job
  };

  bool Before(const Waiter& a, const Waiter& b) const;
  bool MayBegin(const Waiter& waiter) const;
  void Enter(const Waiter& waiter);
  bool Fits(int64_t bytes) const { return used_ + bytes <= limit_; }
  absl::Status Grow(Share& share, int64_t more);
  absl::Status AwaitMemory(Lock& lock, Share& share, int64_t more);
  absl::Status Await(Lock& lock, const CancelToken& cancel);
  void Add(Share& share, int64_t bytes);
  void GiveBack(Share& share, int64_t bytes);
  absl::Status TooLarge(int64_t bytes) const;

  const int64_t limit_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  int64_t used_ = 0;
  int64_t next_turn_ = 0;
  std::list<Waiter> waiting_;
  std::map<std::string, int64_t> by_tenant_;
  /// memory that a job needed when its run ended to free memory for other jobs; indexed by job id
  std::map<std::string, int64_t> needs_;
  Share* growing_ = nullptr;  ///< running job that waits for more memory
};

/// Returns the default limit for the jobs of this program: half of the container's memory, or of
/// the machine's memory without a container limit. The other half is for messages, results and the
/// allocator's reserve.
int64_t DefaultMemoryBudget();

}  // namespace slicefarm
