#include "tests/sim/store_link.h"

#include "common/base/error.h"

namespace slicefarm::coordinator::sim {

absl::Status StoreFailed() {
  return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed, "the store failed");
}

int64_t StoreLink::Delay() {
  const bool slow = world_.Happens(30);
  return world_.random.Between(50, slow ? 800'000 : 3'000);
}

StoreLink::Fate StoreLink::Draw() {
  if (world_.Until(world_.store_away_until_us)) return Fate::kFailsBefore;
  if (!world_.Happens(world_.scenario.store_fault_permille)) return Fate::kWorks;
  ++world_.totals.store_faults;
  switch (world_.random.Below(3)) {
    case 0:
      return Fate::kFailsBefore;
    case 1:
      return Fate::kFailsAfter;
    default:
      return Fate::kFailsAndWorksLate;
  }
}

}  // namespace slicefarm::coordinator::sim
