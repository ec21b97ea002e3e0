#pragma once

#include <condition_variable>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Slots for work that takes long; calls wait for a slot. A tenant with n slots gets another one
/// only if more than n slots are free, so that other tenants find one. Of the waiting calls, the
/// calls of the tenant with the fewest slots come first; of these calls, the earliest. Thread-safe;
/// must outlive its slots.
class TenantSlotQueue {
 public:
  /// Slot of one call. The destructor releases it.
  class Slot {
   public:
    Slot(TenantSlotQueue& queue, std::string tenant) : queue_(&queue), tenant_(std::move(tenant)) {}
    Slot(Slot&& other) noexcept
        : queue_(std::exchange(other.queue_, nullptr)), tenant_(std::move(other.tenant_)) {}
    Slot& operator=(Slot&&) = delete;
    ~Slot();

   private:
    TenantSlotQueue* queue_;
    std::string tenant_;
  };

  /// Creates `slots` slots. REQUIRES: slots >= 1.
  explicit TenantSlotQueue(int slots) : free_(slots) {}

  /// Waits for a slot. The tenant "" of a farm without tenants may use all slots. Errors: the error
  /// of `cancel`.
  absl::StatusOr<Slot> Enter(const std::string& tenant, const CancelToken& cancel);

 private:
  using Waiting = std::list<std::string>;

  bool MayWork(const std::string& tenant) const;
  int AtWork(const std::string& tenant) const;
  Waiting::const_iterator Next() const;
  void Leave(const std::string& tenant);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
  /// Number of slots in use, by tenant; only tenants with at least one.
  std::map<std::string, int> at_work_;
  Waiting waiting_;  ///< tenants of the waiting calls, in the order of the calls
};

}  // namespace slicefarm::coordinator
