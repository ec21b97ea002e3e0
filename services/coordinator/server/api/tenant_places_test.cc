#include "services/coordinator/server/api/tenant_places.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"

namespace slicefarm::coordinator::tenant_places_test {
namespace {

TEST(TenantPlaces, OneTenantLeavesSomeToTheOthers) {
  TenantPlaces places(3, 2);
  for (const auto& [tenant, share] : {std::pair{"a", 2}, {"b", 2}, {"", 3}}) {
    std::vector<absl::StatusOr<rpc::Admission::Ticket>> tickets;
    for (int i = 0; i < share; ++i) {
      tickets.push_back(places.Enter(tenant, {}));
      EXPECT_TRUE(tickets.back().ok()) << tenant;
    }
    EXPECT_EQ(DetailOf(places.Enter(tenant, {}).status()).reason, Reason::kOverloaded) << tenant;
    tickets.pop_back();
    EXPECT_TRUE(places.Enter(tenant, {}).ok()) << tenant;
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_places_test
