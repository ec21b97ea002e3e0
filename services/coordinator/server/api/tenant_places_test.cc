#include "services/coordinator/server/api/tenant_places.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator::tenant_places_test {
namespace {

using Places = std::vector<TenantPlaces::Place>;

/// Takes all slots that the tenant can get. Returns their number.
int TakeAll(TenantPlaces& places, const std::string& tenant, Places& taken) {
  for (int count = 0;; ++count) {
    auto place = places.Enter(tenant);
    if (!place.ok()) return count;
    taken.push_back(*std::move(place));
  }
}

TEST(TenantPlaces, AFarmWithoutTenantsHasAll) {
  TenantPlaces places(5);
  Places taken;
  EXPECT_EQ(TakeAll(places, "", taken), 5);
  taken.pop_back();
  EXPECT_EQ(TakeAll(places, "", taken), 1);
}

TEST(TenantPlaces, HoweverManyTenantsTakeAllTheyCanOneIsLeftForTheNext) {
  TenantPlaces places(64);
  Places taken;
  EXPECT_EQ(TakeAll(places, "first", taken), 32);
  for (int i = 0; i < 5; ++i) {
    EXPECT_GE(TakeAll(places, "tenant" + std::to_string(i), taken), 1) << i;
  }
}

TEST(TenantPlaces, WhoHasTooMuchGetsNothingMoreUntilOthersHadTheirs) {
  TenantPlaces places(12);
  Places a;
  Places b;
  EXPECT_EQ(TakeAll(places, "a", a), 6);
  EXPECT_EQ(TakeAll(places, "b", b), 3);
  a.clear();
  EXPECT_EQ(TakeAll(places, "b", b), 3) << "half of all, as if nobody else had been there";
}

TEST(TenantPlaces, ARefusalTellsWhenToComeAgain) {
  TenantPlaces places(1);
  const auto place = places.Enter("a");
  const ErrorDetail refusal = DetailOf(places.Enter("a").status());
  EXPECT_EQ(refusal.reason, Reason::kOverloaded);
  EXPECT_TRUE(refusal.metadata.contains(rpc::kRetryAfterMs));
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_places_test
