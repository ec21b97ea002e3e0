#include "services/coordinator/server/api/tenant_slots.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator::tenant_slots_test {
namespace {

using Slots = std::vector<TenantSlots::Slot>;

/// Takes all slots that the tenant can get. Returns their number.
int TakeAll(TenantSlots& slots, const std::string& tenant, Slots& taken) {
  for (int count = 0;; ++count) {
    auto slot = slots.Enter(tenant);
    if (!slot.ok()) return count;
    taken.push_back(*std::move(slot));
  }
}

TEST(TenantSlots, AFarmWithoutTenantsHasAll) {
  TenantSlots slots(5);
  Slots taken;
  EXPECT_EQ(TakeAll(slots, "", taken), 5);
  taken.pop_back();
  EXPECT_EQ(TakeAll(slots, "", taken), 1);
}

TEST(TenantSlots, HoweverManyTenantsTakeAllTheyCanOneIsLeftForTheNext) {
  TenantSlots slots(64);
  Slots taken;
  EXPECT_EQ(TakeAll(slots, "first", taken), 32);
  for (int i = 0; i < 5; ++i) {
    EXPECT_GE(TakeAll(slots, "tenant" + std::to_string(i), taken), 1) << i;
  }
}

TEST(TenantSlots, WhoHasTooMuchGetsNothingMoreUntilOthersHadTheirs) {
  TenantSlots slots(12);
  Slots a;
  Slots b;
  EXPECT_EQ(TakeAll(slots, "a", a), 6);
  EXPECT_EQ(TakeAll(slots, "b", b), 3);
  a.clear();
  EXPECT_EQ(TakeAll(slots, "b", b), 3) << "half of all, as if nobody else had been there";
}

TEST(TenantSlots, ARefusalTellsWhenToComeAgain) {
  TenantSlots slots(1);
  const auto slot = slots.Enter("a");
  const ErrorDetail refusal = DetailOf(slots.Enter("a").status());
  EXPECT_EQ(refusal.reason, Reason::kOverloaded);
  EXPECT_TRUE(refusal.metadata.contains(rpc::kRetryAfterMs));
}

}  // namespace
}  // namespace slicefarm::coordinator::tenant_slots_test
