#include "services/infill/algo/space_filling/ring_links.h"

#include <gtest/gtest.h>

#include "services/infill/algo/space_filling/fill_checks_test.h"

namespace slicefarm::infill::ring_links_test {
namespace {

constexpr double kSpacing = 500'000;

Polygon Ring(std::string_view text) { return MakePolygonsOrDie(text)[0].outer; }

double LengthOfRings(const std::vector<StepRing>& rings) {
  double length = 0;
  for (const StepRing& ring : rings) length += Perimeter(ring.points);
  return length;
}

TEST(RingLinks, NothingAndOneRing) {
  EXPECT_TRUE(LinkRings({}, kSpacing).empty());
  const std::vector<StepRing> one = {{Ring("(0 0, 5 0, 5 5, 0 5)"), 0}};
  Polyline closed = one[0].points;
  closed.push_back(closed[0]);
  EXPECT_EQ(LinkRings(one, kSpacing), (std::vector<Polyline>{closed}));
}

// Links are as long as the cuts, so that the length is reduced only by the one link that is
// omitted.
TEST(RingLinks, TwoRingsKeepTheirLength) {
  const std::vector<StepRing> rings = {{Ring("(0 0, 5 0, 5 5, 0 5)"), 0},
                                       {Ring("(0.5 0.5, 4.5 0.5, 4.5 4.5, 0.5 4.5)"), 1}};
  const std::vector<Polyline> paths = LinkRings(rings, kSpacing);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(Length(paths[0]), LengthOfRings(rings) - kSpacing, 10);
  EXPECT_NEAR(Distance(paths[0].front(), paths[0].back()), kSpacing, 2);
  EXPECT_EQ(CrossingsOf(paths), 0);
}

// Odd rings lead inwards, even rings outwards.
TEST(RingLinks, NestedRingsBecomeADoubleSpiral) {
  std::vector<StepRing> rings;
  for (int32_t k = 0; k < 9; ++k) {
    const Coord low = k * 500'000, high = 20'000'000 - low;
    rings.push_back({{{low, low}, {high, low}, {high, high}, {low, high}}, k});
  }
  const std::vector<Polyline> paths = LinkRings(rings, kSpacing);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(Length(paths[0]), LengthOfRings(rings) - kSpacing, 100);
  // The list contains the upper sides in the order in which the path passes them.
  std::vector<Coord> tops;
  for (size_t i = 1; i < paths[0].size(); ++i)
    if (paths[0][i].y == paths[0][i - 1].y && paths[0][i].y > 15'000'000)
      tops.push_back((20'000'000 - paths[0][i].y) / 500'000);
  EXPECT_EQ(tops, (std::vector<Coord>{0, 2, 4, 6, 8, 7, 5, 3, 1}));
}

TEST(RingLinks, BesideEachOther) {
  const std::vector<StepRing> rings = {{Ring("(0 0, 5 0, 5 5, 0 5)"), 0},
                                       {Ring("(5.9 1, 7 1, 7 4, 5.9 4)"), 0},
                                       {Ring("(7.3 2, 9 2, 9 3, 7.3 3)"), 0}};
  const std::vector<Polyline> paths = LinkRings(rings, kSpacing);
  EXPECT_EQ(paths.size(), 1U);
  EXPECT_EQ(CrossingsOf(paths), 0);
}

TEST(RingLinks, NotAcrossThree) {
  const std::vector<StepRing> rings = {{Ring("(0 0, 5 0, 5 5, 0 5)"), 0},
                                       {Ring("(6.6 1, 8 1, 8 4, 6.6 4)"), 0}};
  EXPECT_EQ(LinkRings(rings, kSpacing).size(), 2U);
}

// A grid of small squares: each edge is either kept or replaced by a link.
TEST(RingLinks, SquaresOfAGrid) {
  std::vector<StepRing> rings;
  for (int32_t k = 0; k < 100; ++k) {
    const Point low = {k % 10 * 1'000'000, k / 10 * 1'000'000};
    rings.push_back(
        {{low, low + Point{500'000, 0}, low + Point{500'000, 500'000}, low + Point{0, 500'000}},
         k});
  }
  const std::vector<Polyline> paths = LinkRings(rings, kSpacing);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(Length(paths[0]), 399 * kSpacing);
  EXPECT_EQ(CrossingsOf(paths), 0);
}

// For any rings, links do not cross, and no length is added.
TEST(RingLinks, RandomRings) {
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    const MultiPolygon island = RandomIsland(random, {0, 0}, Uniform(random, 3, 10));
    std::vector<StepRing> rings;
    MultiPolygon inside = Offset(island, -200'000);
    for (int32_t step = 0; !inside.empty() && step < 9; ++step) {
      ForEachRing(inside, [&](const Polygon& ring) {
        if (Perimeter(ring) > 500'000) rings.push_back({ring, step});
      });
      inside = Offset(inside, -std::llround(Uniform(random, 3e5, 7e5)));
    }
    const std::vector<Polyline> paths = LinkRings(rings, kSpacing);
    EXPECT_EQ(CrossingsOf(paths), 0) << i;
    EXPECT_LT(LengthOf(paths), 1.3 * LengthOfRings(rings)) << i;
    EXPECT_GT(LengthOf(paths),
              0.8 * LengthOfRings(rings) - kSpacing * static_cast<double>(paths.size()))
        << i;
  }
}

// Rings of one step may be more or less than a spacing apart: the cuts are as long as this distance
// (see above).
TEST(RingLinks, OfOneStepKeepTheLength) {
  for (const double apart : {0.7, 1.0, 1.6}) {
    const auto inner = FromMm(20 - apart);
    const auto square = [](Coord low, Coord high) {
      return Polygon{{low, low}, {high, low}, {high, high}, {low, high}};
    };
    const std::vector<StepRing> rings = {{square(0, FromMm(20)), 0},
                                         {square(FromMm(apart), inner), 0}};
    const auto paths = LinkRings(rings, 1e6);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_NEAR(Length(paths[0]), LengthOfRings(rings) - apart * 1e6, 100) << apart;
  }
}

}  // namespace
}  // namespace slicefarm::infill::ring_links_test
