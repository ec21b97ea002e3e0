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

/// Slots for work that takes long, for which calls wait. A tenant works in at most as many as are
/// free, so that others find one; of those that wait, the one of the tenant with the least at work
/// comes first, and of these the one that came first. Thread-safe; must outlive its turns.
class TenantTurns {
 public:
  /// Gives the slot back when destroyed.
  class Turn {
   public:
    Turn(TenantTurns& turns, std::string tenant) : turns_(&turns), tenant_(std::move(tenant)) {}
    Turn(Turn&& other) noexcept
        : turns_(std::exchange(other.turns_, nullptr)), tenant_(std::move(other.tenant_)) {}
    Turn& operator=(Turn&&) = delete;
    ~Turn();

   private:
    TenantTurns* turns_;
    std::string tenant_;
  };

  /// REQUIRES: slots >= 1.
  explicit TenantTurns(int slots) : free_(slots) {}

  /// Waits for a slot; the tenant "", whom a farm without tenants has, may have all. Errors:
  /// `cancel`'s.
  absl::StatusOr<Turn> Enter(const std::string& tenant, const CancelToken& cancel);

 private:
  using Waiting = std::list<std::string>;

  bool MayWork(const std::string& tenant) const;
  int AtWork(const std::string& tenant) const;
  Waiting::const_iterator Next() const;
  void Leave(const std::string& tenant);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  int free_;
  std::map<std::string, int> at_work_;  ///< of tenants that have any
  Waiting waiting_;                     ///< tenants, in the order of their calls
};

}  // namespace slicefarm::coordinator
