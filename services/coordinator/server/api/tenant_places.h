#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"

#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Places that calls share, of which a tenant has at most as many as are free: one tenant can take
/// half of them, two a third each, and however many take what they can get, one place is left for
/// who comes with none (the dynamic thresholds of A. Choudhury and E. Hahne, 1998). None waits
/// here. Thread-safe; must outlive its places.
class TenantPlaces {
 public:
  /// Gives the place back when destroyed.
  class Place {
   public:
    Place(TenantPlaces& places, std::string tenant)
        : places_(&places), tenant_(std::move(tenant)) {}
    Place(Place&& other) noexcept
        : places_(std::exchange(other.places_, nullptr)), tenant_(std::move(other.tenant_)) {}
    Place& operator=(Place&&) = delete;
    ~Place();

   private:
    TenantPlaces* places_;
    std::string tenant_;
  };

  /// REQUIRES: all >= 1.
  explicit TenantPlaces(int all) : all_(all) {}

  /// The tenant "", whom a farm without tenants has, may have all. Errors: OVERLOADED, with the
  /// time after which to try again.
  absl::StatusOr<Place> Enter(const std::string& tenant);

 private:
  void Leave(const std::string& tenant);

  const int all_;
  std::mutex mutex_;
  int used_ = 0;
  std::map<std::string, int> by_tenant_;  ///< of those who have any
};

}  // namespace slicefarm::coordinator
