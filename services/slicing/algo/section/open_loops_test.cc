#include "services/slicing/algo/section/open_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm::slicing::open_loops_test {
namespace {

Polyline Reversed(Polyline line) { return {line.rbegin(), line.rend()}; }

double TotalArea(const ClosedChains& closed) {
  double area = 0;
  for (const Polygon& loop : closed.loops) area += SignedArea(loop);
  return area;
}

/// Square of side 1000 in two or four pieces.
const Polyline kBottom = {{0, 0}, {1000, 0}}, kRight = {{1000, 0}, {1000, 1000}},
               kTop = {{1000, 1000}, {0, 1000}}, kLeft = {{0, 1000}, {0, 0}};

struct Case {
  std::string name;
  std::vector<Polyline> chains;
  Coord max_gap;
  int64_t closed, dropped;
  double area, gap;
};

std::vector<Case> Cases() {
  return {
      {"None", {}, 100, 0, 0, 0, 0},
      {"FourSides", {kBottom, kRight, kTop, kLeft}, 0, 1, 0, 1e6, 0},
      {"OneTurned", {kBottom, Reversed(kRight), kTop, kLeft}, 0, 1, 0, 1e6, 0},
      {"ThreeTurned",
       {kBottom, Reversed(kRight), Reversed(kTop), Reversed(kLeft)},
       0,
       1,
       0,
       -1e6,
       0},
      {"OneMissing", {kBottom, kRight, kTop}, 900, 0, 1, 0, 0},
      {"ClosedOverAGap",
       {{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 50}}},
       100,
       1,
       0,
       1e6,
       50},
      {"GapTooWide", {{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 101}}}, 100, 0, 1, 0, 0},
      {"GapExactlyAllowed",
       {{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 100}}},
       100,
       1,
       0,
       1e6,
       100},
      {"ScrapStaysOpen", {{{0, 0}, {10, 0}, {10, 10}}}, 100, 0, 1, 0, 0},
      {"TwoGaps",
       {{{0, 0}, {1000, 0}, {1000, 990}}, {{1000, 1000}, {0, 1000}, {0, 20}}},
       100,
       1,
       0,
       1e6,
       20},
  };
}

TEST(CloseChains, ClosesAsFarAsAllowed) {
  for (const Case& c : Cases()) {
    const ClosedChains closed = CloseChains(c.chains, c.max_gap);
    EXPECT_EQ(closed.counts.closed, c.closed) << c.name;
    EXPECT_EQ(closed.counts.dropped, c.dropped) << c.name;
    EXPECT_DOUBLE_EQ(TotalArea(closed), c.area) << c.name;
    EXPECT_DOUBLE_EQ(closed.counts.largest_gap_nm, c.gap) << c.name;
  }
}

TEST(CloseChains, JoinsNearestFirst) {
  // The gap of 5 sqrt(2) between the lines is bridged before the first line is closed onto itself.
  const ClosedChains closed = CloseChains({{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 30}},
                                           {{-5, 35}, {-500, 30}, {-500, 0}, {-25, 0}}},
                                          100);
  EXPECT_EQ(closed.counts.closed, 1);
  ASSERT_EQ(closed.loops.size(), 1u);
  EXPECT_EQ(closed.loops[0].size(), 9u);
  EXPECT_DOUBLE_EQ(closed.counts.largest_gap_nm, 25);
}

TEST(CloseChains, CountsWhatItDrops) {
  const ClosedChains closed = CloseChains({kBottom, kRight, {{0, 5000}, {300, 5000}}}, 10);
  EXPECT_EQ(closed.counts.dropped, 2);
  EXPECT_DOUBLE_EQ(closed.counts.dropped_length_nm, 2300);
  EXPECT_TRUE(closed.loops.empty());
}

TEST(CloseChains, DoesNotDependOnTheOrder) {
  for (Case c : Cases()) {
    const ClosedChains want = CloseChains(c.chains, c.max_gap);
    std::sort(c.chains.begin(), c.chains.end());
    do {
      const ClosedChains got = CloseChains(c.chains, c.max_gap);
      EXPECT_EQ(got.loops, want.loops) << c.name;
      EXPECT_EQ(got.counts.dropped_length_nm, want.counts.dropped_length_nm) << c.name;
    } while (std::next_permutation(c.chains.begin(), c.chains.end()));
  }
}

/// Every segment of a fine circle is a separate chain, as in a file with corners that do not match
/// to the nanometre.
TEST(CloseChains, JoinsTenThousandPieces) {
  std::vector<Polyline> pieces;
  constexpr int kPieces = 10'000;
  const auto at = [](int i) {
    const double angle = 2 * 3.14159265358979 * i / kPieces;
    return Point{FromMm(20 * std::cos(angle)), FromMm(20 * std::sin(angle))};
  };
  for (int i = 0; i < kPieces; ++i) {
    const Point from = at(i * 7 % kPieces), to = at(i * 7 % kPieces + 1);
    pieces.push_back({from, {to.x + i % 5, to.y - i % 3}});
  }
  const ClosedChains closed = CloseChains(pieces, 2'000'000);
  EXPECT_EQ(closed.counts.closed, 1);
  EXPECT_EQ(closed.counts.dropped, 0);
  EXPECT_LT(closed.counts.largest_gap_nm, 6);
  EXPECT_NEAR(TotalArea(closed) * 1e-12, 1256.637, 0.01);
}

/// Very many ends at one point and in one small area must not cost the square of their number.
TEST(CloseChains, StandsCrowds) {
  std::vector<Polyline> star;
  for (Coord i = 0; i < 20'000; ++i) star.push_back({{0, 0}, {1'000'000 + 3'000 * i, i}});
  EXPECT_EQ(CloseChains(star, 1'000).counts.dropped, 10'000);
  std::vector<Polyline> spot;
  for (Coord i = 0; i < 20'000; ++i)
    spot.push_back({{i * 37 % 1'000, i * 91 % 1'000}, {1'000'000 + 3'000 * i, i}});
  EXPECT_EQ(CloseChains(spot, 2'000).counts.dropped, 10'000);
}

}  // namespace
}  // namespace slicefarm::slicing::open_loops_test
