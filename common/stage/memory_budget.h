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

/// How many bytes all jobs of this process may have in memory together.
///
/// Who wants to begin waits until what it wants fits beside what others have. First comes whose
/// tenant has least, then who has the highest priority, then who waits longest. Who fits may pass
/// those before it that do not, until as much as the whole budget has passed them.
///
/// Who has begun may come to need more. Of those that then do not fit, one waits and the others
/// make room for it: the one that began last ends with OVERLOADED. What it needed is remembered, so
/// that it waits for that before it begins again.
///
/// Thread-safe; must outlive its shares.
class MemoryBudget {
 public:
  /// What one has; given back when it is destroyed. For one thread at a time.
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
    // Under the budget's mutex:
    int64_t turn_ = 0;
    int64_t bytes_ = 0;  ///< that are taken for it: as many as are held, or more
    bool gives_way_ = false;
    bool made_room_ = false;
  };

  explicit MemoryBudget(int64_t limit) : limit_(limit) {}

  /// Room for `bytes` of meshes, and for what the job is known to need beyond them. `cancel` holds
  /// for the share as well. Errors: REQUEST_TOO_LARGE if it does not fit alone; `cancel`'s.
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
    int64_t passed_by = 0;  ///< bytes of those that went before it though they came after
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
  std::map<std::string, int64_t> needs_;  ///< of jobs that made room, by id
  Share* growing_ = nullptr;              ///< who has begun and waits for more
};

/// What the jobs of this process should take at most: half of what the container, or else the
/// machine, has; the rest is for messages under way, results, and what the allocator keeps.
int64_t DefaultMemoryBudget();

}  // namespace slicefarm
