#include "common/stage/memory_budget.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "common/base/error.h"

namespace slicefarm {
namespace {

constexpr std::chrono::milliseconds kPollCancel{20};
constexpr size_t kMostNeeds = 10'000;  ///< limit of remembered needs; beyond it all are forgotten

absl::Status FreesMemory() {
  return MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
                   "other jobs have the memory that this one needs",
                   {{kMemoryKind, "taken"}, {"retry_after_ms", "1000"}});
}

/// Returns the memory limit of the control group, version 2 or 1. Returns the largest int64_t if
/// there is no limit.
int64_t ContainerMemory() {
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    int64_t bytes = 0;
    if (std::ifstream(path) >> bytes && bytes > 0) return bytes;
  }
  return std::numeric_limits<int64_t>::max();
}

int64_t MachineMemory() {
  return static_cast<int64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGE_SIZE);
}

}  // namespace

int64_t DefaultMemoryBudget() { return std::min(ContainerMemory(), MachineMemory()) / 2; }

MemoryBudget::Share::~Share() {
  const Lock lock(budget_.mutex_);
  budget_.GiveBack(*this, bytes_);
  if (!freed_memory_) budget_.needs_.erase(job_);
}

absl::Status MemoryBudget::Share::Hold(Kind kind, int64_t bytes) {
  held_[static_cast<size_t>(kind)] = bytes;
  const int64_t wanted = std::accumulate(held_.begin(), held_.end(), int64_t{0});
  return budget_.Grow(*this, wanted);
}

int64_t MemoryBudget::used() const {
  const Lock lock(mutex_);
  return used_;
}

absl::Status MemoryBudget::TooLarge(int64_t bytes) const {
  const ErrorDetail limit = DetailOf(LimitError(Reason::kRequestTooLarge, "", limit_, bytes));
  auto metadata = limit.metadata;
  metadata[kMemoryKind] = "limit";
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestTooLarge,
                   "the job's meshes, outlines, plan and program take " + std::to_string(bytes) +
                       " bytes of memory, at most " + std::to_string(limit_) + " are there",
                   std::move(metadata));
}

bool MemoryBudget::Before(const Waiter& a, const Waiter& b) const {
  const auto rank = [this](const Waiter& waiter) {
    const auto held = by_tenant_.find(waiter.who.tenant);
    const int64_t bytes = held == by_tenant_.end() ? 0 : held->second;
    const bool waited = waiter.passed_by >= limit_;
    return std::make_tuple(!waited, waited ? 0 : bytes, waited ? 0 : -waiter.who.priority,
                           waiter.turn);
  };
  return rank(a) < rank(b);
}

bool MemoryBudget::MayBegin(const Waiter& waiter) const {
  if (growing_ != nullptr || !Fits(waiter.bytes)) return false;
  return std::ranges::none_of(waiting_, [&](const Waiter& other) {
    return Before(other, waiter) && (Fits(other.bytes) || other.passed_by >= limit_);
  });
}

void MemoryBudget::Enter(const Waiter& waiter) {
  for (Waiter& other : waiting_)
    if (Before(other, waiter)) other.passed_by += waiter.bytes;
}

absl::Status MemoryBudget::Await(Lock& lock, const CancelToken& cancel) {
  changed_.wait_for(lock, kPollCancel);
  lock.unlock();  // the poll may take locks of its own
  absl::Status wanted = cancel.Check();
  lock.lock();
  return wanted;
}

absl::StatusOr<std::unique_ptr<MemoryBudget::Share>> MemoryBudget::Take(const Claimant& who,
                                                                        const std::string& job,
                                                                        int64_t bytes,
                                                                        const CancelToken& cancel) {
  std::unique_ptr<Share> share(new Share(*this, who, job, cancel));
  Lock lock(mutex_);
  if (bytes > limit_) return TooLarge(bytes);
  const auto need = needs_.find(job);
  const int64_t known = need == needs_.end() ? 0 : need->second;
  const auto mine = waiting_.insert(waiting_.end(), {who, std::max(bytes, known), next_turn_++});
  absl::Status wanted;
  while (wanted.ok() && !MayBegin(*mine)) wanted = Await(lock, cancel);
  const Waiter me = *mine;
  waiting_.erase(mine);
  if (wanted.ok()) {
    Enter(me);
    share->turn_ = me.turn;
    Add(*share, me.bytes);
  }
  changed_.notify_all();  // it may be the turn of the next one
  lock.unlock();          // a share that is not given takes it as it goes
  if (!wanted.ok()) return wanted;
  share->held_[static_cast<size_t>(JobMemory::Kind::kMeshes)] = bytes;
  return share;
}

void MemoryBudget::Add(Share& share, int64_t bytes) {
  used_ += bytes;
  share.bytes_ += bytes;
  by_tenant_[share.who_.tenant] += bytes;
}

void MemoryBudget::GiveBack(Share& share, int64_t bytes) {
  if (bytes == 0) return;
  used_ -= bytes;
  share.bytes_ -= bytes;
  const auto held = by_tenant_.find(share.who_.tenant);
  if ((held->second -= bytes) == 0) by_tenant_.erase(held);
  changed_.notify_all();
}

/// Sets the bytes of a share. The memory that an earlier attempt of the job needed stays reserved
/// until the job uses more, so that the job does not fail again.
absl::Status MemoryBudget::Grow(Share& share, int64_t wanted) {
  Lock lock(mutex_);
  if (wanted > limit_) return TooLarge(wanted);
  const auto need = needs_.find(share.job_);
  const int64_t kept = need == needs_.end() ? 0 : need->second;
  const int64_t more = std::max(wanted, kept) - share.bytes_;
  if (more <= 0) {
    GiveBack(share, -more);
    return absl::OkStatus();
  }
  if (!Fits(more))
    if (absl::Status there = AwaitMemory(lock, share, more); !there.ok()) return there;
  Add(share, more);
  return absl::OkStatus();
}

/// Waits until `more` bytes are free. If two jobs wait for more memory, the job that began later
/// ends with OVERLOADED to free its memory. The other job can then continue and will free its own
/// memory when it ends.
absl::Status MemoryBudget::AwaitMemory(Lock& lock, Share& share, int64_t more) {
  absl::Status wanted;
  if (growing_ != nullptr && growing_->turn_ < share.turn_) {
    wanted = FreesMemory();
  } else {
    if (growing_ != nullptr) growing_->yields_ = true;
    growing_ = &share;
  }
  while (wanted.ok() && !Fits(more)) {
    wanted = Await(lock, share.cancel_);
    if (share.yields_) wanted = FreesMemory();
  }
  if (growing_ == &share) growing_ = nullptr;
  changed_.notify_all();
  if (wanted.ok() || !IsOutOfMemory(wanted) || share.job_.empty()) return wanted;
  share.freed_memory_ = true;
  if (needs_.size() >= kMostNeeds) needs_.clear();
  needs_[share.job_] = std::min(limit_, 2 * (share.bytes_ + more));
  return wanted;
}

}  // namespace slicefarm
