#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Slots that calls of all tenants share. A tenant with n calls gets another slot only if more than
/// n slots are free. So one tenant can take half of all slots, two tenants a third each, and one
/// slot always remains for a tenant without any. This is the dynamic threshold method of A.
/// Choudhury and E. Hahne, 1998. Calls never wait for a slot. Thread-safe; must outlive its slots.
class TenantSlots {
 public:
  /// Slot of one call. The destructor releases it.
  class Slot {
   public:
    Slot(TenantSlots& slots, std::string tenant) : slots_(&slots), tenant_(std::move(tenant)) {}
    Slot(Slot&& other) noexcept
        : slots_(std::exchange(other.slots_, nullptr)), tenant_(std::move(other.tenant_)) {}
    Slot& operator=(Slot&&) = delete;
    ~Slot();

   private:
    TenantSlots* slots_;
    std::string tenant_;
  };

  /// Creates `all` slots. REQUIRES: all >= 1.
  explicit TenantSlots(int all) : all_(all) {}

  /// Takes a slot. The tenant "" of a farm without tenants may take all slots. Errors: OVERLOADED,
  /// with the time after which to retry.
  absl::StatusOr<Slot> Enter(const std::string& tenant);

 private:
  void Leave(const std::string& tenant);

  const int all_;
  std::mutex mutex_;
  int used_ = 0;
  std::map<std::string, int> by_tenant_;  ///< number of slots by tenant, for tenants that have any
};

}  // namespace slicefarm::coordinator
