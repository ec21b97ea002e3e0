#pragma once

#include <map>
#include <mutex>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/rpc/server/admission.h"

namespace slicefarm::coordinator {

/// How many of the places that calls share one tenant may have, so that there are some for the
/// others. None waits here. Thread-safe; must outlive its tickets.
class TenantPlaces {
 public:
  /// `all`: of the tenant "", which a farm without tenants has.
  TenantPlaces(int all, int of_each) : all_(all), of_each_(of_each) {}

  /// Errors: OVERLOADED; Cancelled.
  absl::StatusOr<rpc::Admission::Ticket> Enter(const std::string& tenant,
                                               const CancelToken& cancel) {
    return Of(tenant).Enter(cancel);
  }

 private:
  rpc::Admission& Of(const std::string& tenant) {
    const std::lock_guard lock(mutex_);
    return by_tenant_.try_emplace(tenant, tenant.empty() ? all_ : of_each_, 0).first->second;
  }

  const int all_;
  const int of_each_;
  std::mutex mutex_;
  std::map<std::string, rpc::Admission> by_tenant_;
};

}  // namespace slicefarm::coordinator
