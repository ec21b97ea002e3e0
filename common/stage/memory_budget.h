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
/// A new job waits until its memory fits beside the memory of the running jobs. The order of
/// waiting jobs: first the tenant that uses the least memory, then the highest priority, then the
/// longest wait. A job that fits may overtake earlier jobs that do not fit, until the overtaking
/// jobs have used as much as the whole budget.
///
/// A running job may need more memory. If several such jobs do not fit, one of them waits, and the
/// job that began last ends with OVERLOADED to free memory. The budget remembers the memory that
/// this job needed. When the job is tried again, it waits for this amount before it begins.
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
    // Protected by the budget's mutex:
    int64_t turn_ = 0;
    int64_t bytes_ = 0;  ///< reserved bytes: at least the used bytes
    bool gives_way_ = false;
    bool made_room_ = false;
  };

  explicit MemoryBudget(int64_t limit) : limit_(limit) {}

  /// Waits until there is memory for `bytes` of meshes, and for the additional memory that an
  /// earlier attempt of the job needed. `cancel` also applies to the share. Errors:
  /// REQUEST_TOO_LARGE if the job does not fit even alone; the error of `cancel`.
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
    int64_t passed_by = 0;  ///< bytes of the jobs that have overtaken this one
  };

  bool Before(const Waiter& a, const Waiter& b) const;
  bool MayBegin(const Waiter& waiter) const;
  void Enter(const Waiter& waiter);
  bool Fits(int64_t bytes) const { return used_ + bytes <= limit_; }
  absl::Status Grow(Share& share, int64_t more);
  absl::Status AwaitRoom(Lock& lock, Share& share, int64_t more);
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
  std::map<std::string, int64_t> needs_;  ///< needs of the jobs that had to free memory, by job id
  Share* growing_ = nullptr;              ///< running job that waits for more memory
};

/// Returns the default limit for the jobs of this process: half of the memory of the container, or
/// else of the machine. The other half is for messages, results and the allocator's reserve.
int64_t DefaultMemoryBudget();

}  // namespace slicefarm
