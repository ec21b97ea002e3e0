#include "services/coordinator/server/api/tenant_slot_queue.h"

#include "common/rpc/retry_after.h"

namespace slicefarm::coordinator {

TenantSlotQueue::Slot::~Slot() {
  if (queue_ != nullptr) queue_->Leave(tenant_);
}

absl::StatusOr<TenantSlotQueue::Slot> TenantSlotQueue::Enter(const std::string& tenant,
                                                             const CancelToken& cancel) {
  std::unique_lock lock(mutex_);
  const auto mine = waiting_.insert(waiting_.end(), tenant);
  absl::Status wanted;
  while (wanted.ok() && Next() != mine) {
    changed_.wait_for(lock, rpc::kPollCancel);
    lock.unlock();  // the cancellation check may take locks of its own
    wanted = cancel.Check();
    lock.lock();
  }
  waiting_.erase(mine);
  if (wanted.ok()) {
    --free_;
    ++at_work_[tenant];
  }
  changed_.notify_all();  // another call may get the slot
  if (!wanted.ok()) return wanted;
  return Slot(*this, tenant);
}

int TenantSlotQueue::AtWork(const std::string& tenant) const {
  const auto found = at_work_.find(tenant);
  return found == at_work_.end() ? 0 : found->second;
}

bool TenantSlotQueue::MayWork(const std::string& tenant) const {
  return tenant.empty() ? free_ > 0 : AtWork(tenant) < free_;
}

/// Returns the waiting call that gets the next slot; end() if no waiting call may get a slot now.
TenantSlotQueue::Waiting::const_iterator TenantSlotQueue::Next() const {
  auto next = waiting_.end();
  for (auto i = waiting_.begin(); i != waiting_.end(); ++i) {
    if (!MayWork(*i)) continue;
    if (next == waiting_.end() || AtWork(*i) < AtWork(*next)) next = i;
  }
  return next;
}

void TenantSlotQueue::Leave(const std::string& tenant) {
  {
    const std::lock_guard lock(mutex_);
    ++free_;
    const auto found = at_work_.find(tenant);
    if (--found->second == 0) at_work_.erase(found);
  }
  changed_.notify_all();
}

}  // namespace slicefarm::coordinator
