#include "processes/laser/wire/laser_work.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::laser_work_test {
namespace {

LaserWork Work() {
  LaserWork work;
  auto& [range, shared] = work;
  range = {3, 5};
  shared = "00112233";
  return work;
}

TEST(LaserWork, Returns) {
  const absl::StatusOr<LaserWork> back = FromProto(ProtoOf<v1::LaserWork>(Work()));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(back->range, (LayerRange{3, 5}));
  EXPECT_EQ(back->shared, "00112233");
  ExpectEveryChangeReturns<v1::LaserWork, LaserWork>(ProtoOf<v1::LaserWork>(Work()));
}

TEST(LaserWork, RefusesARangeThatNoJobHas) {
  auto work = ProtoOf<v1::LaserWork>(Work());
  work.clear_range();
  ExpectMalformed(FromProto(work).status(), "range");
}

}  // namespace
}  // namespace slicefarm::laser_work_test
