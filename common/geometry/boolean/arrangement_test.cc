#include "common/geometry/boolean/arrangement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "common/geometry/boolean/near_edges.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::internal::arrangement_test {
namespace {

std::vector<GroupedRing> Rings(std::vector<std::string_view> texts) {
  std::vector<GroupedRing> rings;
  for (const std::string_view text : texts) rings.push_back({MakeLineOrDie(text)});
  return rings;
}

double Mm2(const std::optional<MultiPolygon>& region) { return region ? Area(*region) / 1e12 : -1; }

// Three squares, each over a corner of the next one. All three overlap in the middle.
const std::vector<std::string_view> kThree = {"(0 0, 4 0, 4 4, 0 4)", "(1 1, 5 1, 5 5, 1 5)",
                                              "(2 -1, 6 -1, 6 3, 2 3)"};

TEST(Arrangement, CountsHowOftenRingsWind) {
  const auto rings = Rings(kThree);
  EXPECT_NEAR(Mm2(TryWindingRegion(rings, 1)), 31, 1e-9);
  EXPECT_NEAR(Mm2(TryWindingRegion(rings, 2)), 13, 1e-9);
  EXPECT_NEAR(Mm2(TryWindingRegion(rings, 3)), 4, 1e-9);
  EXPECT_NEAR(Mm2(TryWindingRegion(rings, 4)), 0, 1e-9);
}

// Far coordinates leave no bits for the index in the numbers that are sorted otherwise.
TEST(Arrangement, SweepsInOrderAtAnyDistance) {
  std::mt19937 random(3);
  for (const Coord farthest : {Coord{5}, Coord{1'000'000'000}, Coord{1} << 60}) {
    Polygon ring;
    for (int i = 0; i < 300; ++i) {
      const auto x = static_cast<Coord>(random());
      ring.push_back({x % (2 * farthest) - farthest, i == 7 ? farthest : -farthest});
    }
    std::vector<BoxedEdge> edges;
    AppendBoxedEdges(ring, 0, edges);
    for (Coord Point::*along : {&Point::x, &Point::y}) {
      std::vector<uint32_t> expected(edges.size());
      std::iota(expected.begin(), expected.end(), 0);
      std::ranges::stable_sort(expected, {}, [&](uint32_t i) { return edges[i].min.*along; });
      EXPECT_THAT(SweepOrder(edges, along), testing::ElementsAreArray(expected)) << farthest;
    }
  }
}

TEST(Arrangement, RingsTheOtherWayRoundTakeAway) {
  const auto rings = Rings({"(0 0, 4 0, 4 4, 0 4)", "(1 1, 1 5, 5 5, 5 1)"});
  EXPECT_NEAR(Mm2(TryWindingRegion(rings, 1)), 7, 1e-9);
}

TEST(Arrangement, ARingMayCrossItself) {
  // A pentagram: its middle has the winding number two.
  const auto star = Rings({"(0 3, -1.76 -2.43, 2.85 0.93, -2.85 0.93, 1.76 -2.43)"});
  const double all = Mm2(TryWindingRegion(star, 1)), middle = Mm2(TryWindingRegion(star, 2));
  EXPECT_NEAR(all + middle, SignedArea(star[0].points) / 1e12, 1e-5);
  EXPECT_GT(middle, 2);
  // A loop that is turned inside out has the winding number -1, and vanishes.
  const auto twisted = Rings({"(0 0, 5 0, 5 2, 3 2, 4 3, 5 4, 0 4)", "(10 0, 14 3, 14 0, 10 4)"});
  EXPECT_NEAR(Mm2(TryWindingRegion(twisted, 1)), 18 + 32.0 / 7, 1e-5);
}

TEST(Arrangement, HolesFindTheirIsland) {
  const auto region = TryWindingRegion(Rings({"(0 0, 10 0, 10 10, 0 10)", "(1 1, 1 9, 9 9, 9 1)",
                                              "(2 2, 8 2, 8 8, 2 8)", "(3 3, 3 7, 7 7, 7 3)"}),
                                       1);
  ASSERT_TRUE(region.has_value());
  ASSERT_EQ(region->size(), 2u);
  EXPECT_EQ((*region)[0].holes.size(), 1u);
  EXPECT_EQ((*region)[1].holes.size(), 1u);
  EXPECT_NEAR(Mm2(region), 100 - 64 + 36 - 16, 1e-9);
}

struct DoubtCase {
  std::string name;
  std::vector<std::string_view> rings;
};
class Doubtful : public testing::TestWithParam<DoubtCase> {};

TEST_P(Doubtful, IsLeftToOthers) {
  EXPECT_FALSE(TryWindingRegion(Rings(GetParam().rings), 1).has_value());
}

INSTANTIATE_TEST_SUITE_P(
    Arrangement, Doubtful,
    testing::Values(
        DoubtCase{"SameRing", {"(0 0, 4 0, 4 4, 0 4)", "(0 0, 4 0, 4 4, 0 4)"}},
        DoubtCase{"CornerOnEdge", {"(0 0, 4 0, 4 4, 0 4)", "(4 2, 6 0, 6 4)"}},
        DoubtCase{"OverlappingEdges", {"(0 0, 4 0, 4 4, 0 4)", "(1 0, 3 0, 3 -2, 1 -2)"}},
        DoubtCase{"ThreeThroughOnePoint",
                  {"(0 0, 4 4, 4 5, 0 1)", "(0 4, 4 0, 4 1, 0 5)", "(1.5 2, 3 2, 3 3, 1.5 2.5)"}},
        DoubtCase{"Spike", {"(0 0, 4 0, 8 0, 4 0, 4 4, 0 4)"}},
        DoubtCase{"Flat", {"(0 0, 4 0, 8 0)"}}),
    [](const auto& info) { return info.param.name; });

// The ray of each small ring tests the many edges of the ring around all of them.
TEST(Arrangement, ManyRingsBesideManyEdgesAreLeftToOthers) {
  Polygon disc;
  for (int i = 0; i < 60'000; ++i) {
    const double a = 2 * std::numbers::pi * i / 60'000;
    disc.push_back({FromMm(1'000 * std::cos(a)), FromMm(1'000 * std::sin(a))});
  }
  const auto perforated = [&disc](int holes) {
    std::vector<GroupedRing> rings = {{disc}};
    for (int i = 0; i < holes; ++i) {
      const Coord x = FromMm(0.9 * (i - holes / 2)), size = FromMm(0.3);
      rings.push_back({{{x, 0}, {x, size}, {x + size, size}}});
    }
    return rings;
  };
  EXPECT_TRUE(TryWindingRegion(perforated(1'000), 1).has_value());
  EXPECT_FALSE(TryWindingRegion(perforated(2'000), 1).has_value());
}

TEST(Arrangement, NothingOfNothing) { EXPECT_TRUE(TryWindingRegion({}, 1)->empty()); }

}  // namespace
}  // namespace slicefarm::internal::arrangement_test
