#include "services/infill/algo/linking/taken_edge.h"

#include <gtest/gtest.h>

namespace slicefarm::infill::taken_edge_test {
namespace {

constexpr Coord kWidth = 450'000;

TEST(ClearanceAlong, StopsAtWhatIsTaken) {
  const std::vector<TakenSpan> taken = {{10e6, 12e6, 0}, {55e6, 60e6, 1}};
  const SpanClearance free = ClearanceAlong(taken, 60e6, 20e6, 10e6, kWidth);
  EXPECT_TRUE(free.links);
  EXPECT_EQ(free.ahead_nm, 10e6);
  const SpanClearance blocked = ClearanceAlong(taken, 60e6, 5e6, 20e6, kWidth);
  EXPECT_FALSE(blocked.links);
  EXPECT_EQ(blocked.ahead_nm, 5e6);
  EXPECT_EQ(blocked.behind_nm, 13e6);
  // The edge part passes the ring's first point.
  const SpanClearance around = ClearanceAlong(taken, 60e6, 50e6, 22e6, kWidth);
  EXPECT_FALSE(around.links);
  EXPECT_EQ(around.ahead_nm, 5e6);
  EXPECT_EQ(around.behind_nm, 0);
}

}  // namespace
}  // namespace slicefarm::infill::taken_edge_test
