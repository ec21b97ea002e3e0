#include "common/base/byte_budget.h"

#include <chrono>

namespace slicefarm {
namespace {

constexpr std::chrono::milliseconds kPollCancel{20};

}  // namespace

ByteBudget::Share::~Share() {
  if (budget_ != nullptr) budget_->GiveBack(bytes_);
}

absl::StatusOr<ByteBudget::Share> ByteBudget::Take(int64_t bytes, const CancelToken& cancel) {
  std::unique_lock lock(mutex_);
  const int64_t mine = next_turn_++;
  waiting_.insert(mine);
  const auto fits = [&] {
    return *waiting_.begin() == mine && (used_ == 0 || used_ + bytes <= limit_);
  };
  absl::Status wanted;
  while (wanted.ok() && !fits()) {
    changed_.wait_for(lock, kPollCancel);
    lock.unlock();  // the poll may take locks of its own
    wanted = cancel.Check();
    lock.lock();
  }
  waiting_.erase(mine);
  changed_.notify_all();  // it may be the turn of the next one
  if (!wanted.ok()) return wanted;
  used_ += bytes;
  return Share(*this, bytes);
}

void ByteBudget::GiveBack(int64_t bytes) {
  {
    const std::lock_guard lock(mutex_);
    used_ -= bytes;
  }
  changed_.notify_all();
}

}  // namespace slicefarm
