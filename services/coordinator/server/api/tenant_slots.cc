#include "services/coordinator/server/api/tenant_slots.h"

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {

TenantSlots::Slot::~Slot() {
  if (slots_ != nullptr) slots_->Leave(tenant_);
}

absl::StatusOr<TenantSlots::Slot> TenantSlots::Enter(const std::string& tenant) {
  const std::lock_guard lock(mutex_);
  const auto found = by_tenant_.find(tenant);
  const int mine = found == by_tenant_.end() ? 0 : found->second;
  const int free = all_ - used_;
  if (tenant.empty() ? free <= 0 : mine >= free) {
    return MakeError(
        absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
        "the tenant already has as many calls of this kind in progress as it may have now",
        {{"limit", std::to_string(mine)}, {rpc::kRetryAfterMs, "200"}});
  }
  ++used_;
  ++by_tenant_[tenant];
  return Slot(*this, tenant);
}

void TenantSlots::Leave(const std::string& tenant) {
  const std::lock_guard lock(mutex_);
  --used_;
  const auto found = by_tenant_.find(tenant);
  if (--found->second == 0) by_tenant_.erase(found);
}

}  // namespace slicefarm::coordinator
