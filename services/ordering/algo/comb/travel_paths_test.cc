#include "services/ordering/algo/comb/travel_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simplify.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::ordering::travel_paths_test {
namespace {

constexpr Coord kClearance = 225'000;
constexpr double kAnyLength = std::numeric_limits<double>::infinity();

/// Largest saving in nm when a path cuts lane corners by less than the border's distance.
constexpr double kHairs = 20'000;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

std::optional<std::vector<Point>> Find(TravelPaths& paths, Point a, Point b,
                                       double longest_nm = kAnyLength, int64_t moves = 1'000'000) {
  WorkBudget budget{moves};
  return paths.Find(a, b, longest_nm, budget);
}

/// Returns the path a, corners, b.
std::vector<Point> Whole(Point a, std::vector<Point> corners, Point b) {
  corners.insert(corners.begin(), a);
  corners.push_back(b);
  return corners;
}

bool MeetsAnEdge(Point a, Point b, const MultiPolygon& region) {
  bool meets = false;
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point c = ring[i], d = ring[(i + 1) % ring.size()];
      const bool apart = Orientation(a, b, c) * Orientation(a, b, d) > 0 ||
                         Orientation(c, d, a) * Orientation(c, d, b) > 0;
      meets |= !apart || OnSegment(a, c, d) || OnSegment(c, a, b);
    }
  });
  return meets;
}

MultiPolygon LanesOf(const PolygonWithHoles& island) {
  return Simplify(Offset({island}, -kClearance * 3 / 2), std::llround(0.15 * kClearance));
}

/// Returns the length of the shortest path over any corners of the lanes: Bellman-Ford over all
/// pairs of corners that see each other.
double ShortestByAllPairs(const PolygonWithHoles& island, Point a, Point b) {
  const MultiPolygon lanes = LanesOf(island);
  const MultiPolygon clear = Offset(lanes, 5'000);
  std::vector<Point> places = {a, b};
  for (const Polygon& ring : Rings(lanes)) places.insert(places.end(), ring.begin(), ring.end());
  struct Sight {
    size_t from, to;
  };
  std::vector<Sight> sights;
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (!MeetsAnEdge(places[i], places[j], clear)) sights.push_back({i, j});
  std::vector<double> length(places.size(), kAnyLength);
  length[0] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [i, j] : sights) {
      const double between = Distance(places[i], places[j]);
      for (const auto& [from, to] : {Sight{i, j}, Sight{j, i}}) {
        if (length[from] + between >= length[to] - 1e-3) continue;
        length[to] = length[from] + between;
        changed = true;
      }
    }
  }
  return length[1];
}

class RandomPaths : public testing::TestWithParam<int> {
 protected:
  RandomPaths() : island_(RandomIsland(random_, {}, 20).front()), inner_(LanesOf(island_)) {}

  /// Chooses a random point between the lanes. Returns false if it finds no such point.
  bool Place(Point& p) {
    for (int i = 0; i < 1'000; ++i) {
      p = {FromMm(Uniform(random_, -20, 20)), FromMm(Uniform(random_, -20, 20))};
      if (Inside(p, inner_)) return true;
    }
    return false;
  }

  std::mt19937 random_{static_cast<uint32_t>(GetParam())};
  PolygonWithHoles island_;
  MultiPolygon inner_;
};

TEST_P(RandomPaths, AreAsShortAsTheBestOfAllPairsAndKeepClear) {
  TravelPaths paths({island_}, kClearance);
  const MultiPolygon clear = Offset({island_}, -kClearance * 13 / 10);
  for (int i = 0; i < 12; ++i) {
    Point a, b;
    if (!Place(a) || !Place(b)) return;
    const auto corners = Find(paths, a, b);
    const double shortest = ShortestByAllPairs(island_, a, b);
    ASSERT_EQ(corners.has_value(), shortest < kAnyLength);
    if (!corners) continue;
    const std::vector<Point> path = Whole(a, *corners, b);
    EXPECT_NEAR(Length(path), shortest, kHairs);
    for (size_t k = 1; k < path.size(); ++k) EXPECT_FALSE(MeetsAnEdge(path[k - 1], path[k], clear));
    EXPECT_EQ(corners->empty(), !MeetsAnEdge(a, b, Offset(inner_, 5'000)));
  }
}

TEST_P(RandomPaths, AreTheSameInAMirrorAndBackwards) {
  TravelPaths paths({island_}, kClearance), mirrored(Mirrored(MultiPolygon{island_}), kClearance);
  for (int i = 0; i < 12; ++i) {
    Point a, b;
    if (!Place(a) || !Place(b)) return;
    const auto there = Find(paths, a, b), back = Find(paths, b, a);
    const auto other = Find(mirrored, {-a.x, a.y}, {-b.x, b.y});
    ASSERT_EQ(there.has_value(), other.has_value());
    ASSERT_EQ(there.has_value(), back.has_value());
    if (!there) continue;
    const double length = Length(Whole(a, *there, b));
    EXPECT_NEAR(length, Length(Whole({-a.x, a.y}, *other, {-b.x, b.y})), kHairs);
    EXPECT_NEAR(length, Length(Whole(b, *back, a)), kHairs);
  }
}

TEST_P(RandomPaths, DoNotDependOnWhatWasAskedBefore) {
  TravelPaths used({island_}, kClearance);
  for (int i = 0; i < 12; ++i) {
    Point a, b;
    if (!Place(a) || !Place(b)) return;
    TravelPaths fresh({island_}, kClearance);
    EXPECT_EQ(Find(used, a, b), Find(fresh, a, b));
  }
}

TEST_P(RandomPaths, FromTheOuterWallStayInside) {
  TravelPaths paths({island_}, kClearance);
  // Centre line of the outer wall.
  const MultiPolygon wall = Offset({island_}, -kClearance);
  const std::vector<Polygon> rings = Rings(wall);
  for (int i = 0; i < 12; ++i) {
    const Polygon& from = rings[random_() % rings.size()];
    const Polygon& to = rings[random_() % rings.size()];
    const Point a = from[random_() % from.size()], b = to[random_() % to.size()];
    const auto corners = Find(paths, a, b);
    if (!corners) continue;  // no lane joins the wall's pieces
    const std::vector<Point> path = Whole(a, *corners, b);
    for (size_t k = 1; k < path.size(); ++k)
      EXPECT_FALSE(MeetsAnEdge(path[k - 1], path[k], {island_}));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPaths, testing::Range(0, 30));

/// Returns a fork: two arms 10 mm wide, joined at the bottom, with a slot of 4 mm between them.
PolygonWithHoles Fork() {
  return MakePolygonsOrDie("(0 0, 24 0, 24 20, 14 20, 14 10, 10 10, 10 20, 0 20)").front();
}

TEST(TravelPaths, GoesRoundASlot) {
  TravelPaths paths({Fork()}, kClearance);
  const Point a = Mm(5, 18), b = Mm(19, 18);
  EXPECT_FALSE(paths.IsClear(a, b));
  const auto corners = Find(paths, a, b);
  ASSERT_TRUE(corners);
  ASSERT_EQ(corners->size(), 2U);
  EXPECT_LT(Distance((*corners)[0], Mm(10, 10)), 1.5 * 1.5 * kClearance);
  EXPECT_LT(Distance((*corners)[1], Mm(14, 10)), 1.5 * 1.5 * kClearance);
}

TEST(TravelPaths, FromWallToWallGoesRoundASlot) {
  TravelPaths paths({Fork()}, kClearance);
  const Point a = Mm(9.775, 18), b = Mm(14.225, 18);
  const auto corners = Find(paths, a, b);
  ASSERT_TRUE(corners);
  const std::vector<Point> path = Whole(a, *corners, b);
  for (size_t k = 1; k < path.size(); ++k)
    EXPECT_FALSE(MeetsAnEdge(path[k - 1], path[k], {Fork()}));
}

// The string from a point beside a seam on one side of a hole to the other side follows the lane.
TEST(TravelPaths, FromBesideTheWallOfAHoleGoesRoundIt) {
  const PolygonWithHoles island =
      MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (8 8, 8 12, 12 12, 12 8)").front();
  TravelPaths paths({island}, kClearance);
  for (const Point seam : {Mm(8, 10), Mm(8, 8), Mm(10, 8), Mm(8, 11.9)}) {
    const auto beside = paths.FromEdge(seam);
    ASSERT_TRUE(beside);
    EXPECT_LT(Distance(*beside, seam), 2.5 * kClearance);
    EXPECT_GT(Distance(*beside, seam), kClearance);
    EXPECT_TRUE(Find(paths, *beside, Mm(19, 19))) << ToText(seam);
    EXPECT_TRUE(Find(paths, Mm(19, 11), *beside)) << ToText(seam);
  }
  EXPECT_FALSE(paths.FromEdge(Mm(-5, 10))) << "far from all lanes";
}

TEST(TravelPaths, FindsNothingLongerThanAllowed) {
  TravelPaths paths({Fork()}, kClearance);
  const Point a = Mm(5, 18), b = Mm(19, 18);
  const double length = Length(Whole(a, *Find(paths, a, b), b));
  EXPECT_TRUE(Find(paths, a, b, length + 1));
  EXPECT_FALSE(Find(paths, a, b, length - 1));
}

TEST(TravelPaths, FindsNothingWithoutABudget) {
  TravelPaths paths({Fork()}, kClearance);
  EXPECT_FALSE(Find(paths, Mm(5, 18), Mm(19, 18), kAnyLength, 0));
  EXPECT_TRUE(Find(paths, Mm(5, 18), Mm(19, 18)));
}

TEST(TravelPaths, AWayAlongTheWallIsClearOnlyIfItKeepsOff) {
  const TravelPaths paths({Fork()}, kClearance);
  EXPECT_TRUE(paths.IsClear(Mm(1, 1), Mm(23, 1)));
  EXPECT_FALSE(paths.IsClear(Mm(1, 0.1), Mm(23, 0.1))) << "on the outer wall's outside";
  EXPECT_TRUE(paths.IsClear(Mm(0.225, 5), Mm(9.775, 15))) << "from wall to wall";
  EXPECT_FALSE(paths.IsClear(Mm(9.775, 15), Mm(14.225, 15))) << "over the slot";
}

// A neck narrower than two clearances cannot be passed.
TEST(TravelPaths, DoesNotSqueezeThrough) {
  TravelPaths paths(
      MakePolygonsOrDie("(0 0, 10 0, 10 4.8, 20 4.8, 20 0, 30 0, 30 10, 20 10, 20 5.2, 10 5.2,"
                        " 10 10, 0 10)"),
      kClearance);
  EXPECT_FALSE(Find(paths, Mm(5, 1), Mm(25, 1)));
}

TEST(TravelPaths, OfAnIslandWithoutRoom) {
  TravelPaths paths(MakePolygonsOrDie("(0 0, 10 0, 10 0.3, 0 0.3)"), kClearance);
  EXPECT_FALSE(Find(paths, Mm(1, 0.15), Mm(9, 0.15)));
}

}  // namespace
}  // namespace slicefarm::ordering::travel_paths_test
