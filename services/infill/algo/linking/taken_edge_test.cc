#include "services/infill/algo/linking/taken_edge.h"

#include <gtest/gtest.h>

namespace slicefarm::infill::taken_edge_test {
namespace {

constexpr Coord kWidth = 450'000;

TEST(TakenRing, StopsAtWhatIsTaken) {
  const std::vector<TakenSpan> taken = {{10e6, 12e6, 0}, {55e6, 60e6, 1}};
  const TakenRing ring(taken, 60e6);
  const SpanClearance free = ring.Along(20e6, 10e6, kWidth);
  EXPECT_TRUE(free.links);
  EXPECT_EQ(free.ahead_nm, 10e6);
  const SpanClearance blocked = ring.Along(5e6, 20e6, kWidth);
  EXPECT_FALSE(blocked.links);
  EXPECT_EQ(blocked.ahead_nm, 5e6);
  EXPECT_EQ(blocked.behind_nm, 13e6);
  // The edge part passes the ring's first point.
  const SpanClearance around = ring.Along(50e6, 22e6, kWidth);
  EXPECT_FALSE(around.links);
  EXPECT_EQ(around.ahead_nm, 5e6);
  EXPECT_EQ(around.behind_nm, 0);
}

TEST(TakenRing, ALongPartBeforeShortOnesCounts) {
  const std::vector<TakenSpan> taken = {{0, 50e6, 0}, {10e6, 12e6, 1}, {20e6, 22e6, 2}};
  const SpanClearance room = TakenRing(taken, 60e6).Along(30e6, 10e6, kWidth);
  EXPECT_FALSE(room.links);
  EXPECT_EQ(room.ahead_nm, 0);
}

// A search from the ring's first point for each edge part would be quadratic.
TEST(TakenRing, ManyPartsAreFast) {
  std::vector<TakenSpan> taken;
  for (int32_t i = 0; i < 300'000; ++i) taken.push_back({2e6 * i, 2e6 * i + 1e6, i});
  const TakenRing ring(taken, 6e11);
  double free_nm = 0;
  for (int32_t i = 0; i < 300'000; ++i)
    free_nm += ring.Along(2e6 * i + 1e6, 1.5e6, kWidth).ahead_nm;
  EXPECT_NEAR(free_nm, 3e11, 1);
}

}  // namespace
}  // namespace slicefarm::infill::taken_edge_test
