#include "services/ordering/algo/comb/edge_strips.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::ordering::edge_strips_test {
namespace {

using Segment = std::pair<Point, Point>;

EdgeStrips StripsOf(const std::vector<Segment>& segments) {
  EdgeStrips edges;
  for (const auto& [a, b] : segments) edges.AddLine(std::vector{a, b});
  edges.Build();
  return edges;
}

EdgeStrips StripsOf(const MultiPolygon& region) {
  EdgeStrips edges;
  ForEachRing(region, [&](const Polygon& ring) { edges.AddRing(ring); });
  edges.Build();
  return edges;
}

/// Intersection of two lines with small coordinates, solved in whole numbers.
struct Meeting {
  bool touch = false;
  bool inside_both = false;
};
Meeting Solve(const Segment& s, const Segment& t) {
  const auto cross = [](Point u, Point v) { return u.x * v.y - u.y * v.x; };
  const auto dot = [](Point u, Point v) { return u.x * v.x + u.y * v.y; };
  const Point u = s.second - s.first, v = t.second - t.first, w = t.first - s.first;
  Coord det = cross(u, v);
  if (det != 0) {
    Coord along_s = cross(w, v), along_t = cross(w, u);
    if (det < 0) det = -det, along_s = -along_s, along_t = -along_t;
    return {0 <= along_s && along_s <= det && 0 <= along_t && along_t <= det,
            0 < along_s && along_s < det && 0 < along_t && along_t < det};
  }
  const auto lies_on = [&](Point p, const Segment& on) {
    const Point whole = on.second - on.first, part = p - on.first;
    return cross(whole, part) == 0 && 0 <= dot(whole, part) && dot(part, part) <= dot(whole, whole);
  };
  return {
      lies_on(s.first, t) || lies_on(s.second, t) || lies_on(t.first, s) || lies_on(t.second, s),
      false};
}

class RandomEdges : public testing::TestWithParam<int> {
 protected:
  Point Somewhere() {
    const auto one = [this] { return static_cast<Coord>(random_() % size_) - size_ / 2; };
    return {one(), one()};
  }
  Segment Something() { return {Somewhere(), Somewhere()}; }

  std::mt19937 random_{static_cast<uint32_t>(GetParam())};
  Coord size_ = GetParam() % 2 == 0 ? 9 : 20'000;  // small rings share corners and edges
};

TEST_P(RandomEdges, AreMetAndCrossedAsAllOfThemSay) {
  std::vector<Segment> segments(1 + random_() % 60);
  for (Segment& segment : segments) segment = Something();
  const EdgeStrips edges = StripsOf(segments);
  for (int i = 0; i < 200; ++i) {
    const Segment s = Something();
    Meeting expected;
    for (const Segment& segment : segments) {
      const Meeting one = Solve(s, segment);
      expected.touch |= one.touch;
      expected.inside_both |= one.inside_both;
    }
    EXPECT_EQ(edges.Meets(s.first, s.second), expected.touch);
    EXPECT_EQ(edges.Crosses(s.first, s.second), expected.inside_both);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEdges, testing::Range(0, 20));

TEST(EdgeStrips, SurroundsWhatIsInside) {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const MultiPolygon island = RandomIsland(random, {}, 20);
    const EdgeStrips edges = StripsOf(island);
    for (int i = 0; i < 100; ++i) {
      const Point p{FromMm(Uniform(random, -22, 22)), FromMm(Uniform(random, -22, 22))};
      EXPECT_EQ(edges.Surrounds(p), Inside(p, island));
    }
    // Points at the heights of corners are tested too.
    for (const Point corner : island.front().outer) {
      const Point p{corner.x + 1'234'567, corner.y};
      EXPECT_EQ(edges.Surrounds(p), Inside(p, island));
    }
  }
}

TEST(EdgeStrips, CrossesOnlyWhatComesBefore) {
  EdgeStrips edges;
  edges.AddLine(std::vector<Point>{{0, 0}, {10, 0}}, 1);
  edges.AddLine(std::vector<Point>{{0, 4}, {10, 4}}, 3);
  edges.Build();
  EXPECT_FALSE(edges.Crosses({5, -1}, {5, 5}, 1));
  EXPECT_TRUE(edges.Crosses({5, -1}, {5, 5}, 2));
  EXPECT_FALSE(edges.Crosses({5, 1}, {5, 5}, 3));
  EXPECT_TRUE(edges.Crosses({5, 1}, {5, 5}, 4));
  EXPECT_FALSE(edges.Crosses({5, 0}, {5, 3})) << "it begins there";
}

TEST(EdgeStrips, OfNothing) {
  EdgeStrips edges;
  edges.Build();
  EXPECT_TRUE(edges.empty());
  EXPECT_FALSE(edges.Meets({0, 0}, {1, 1}));
  EXPECT_FALSE(edges.Surrounds({0, 0}));
}

TEST(EdgeStrips, OfLevelEdges) {
  const EdgeStrips edges = StripsOf(std::vector<Segment>{{{0, 0}, {10, 0}}, {{20, 0}, {30, 0}}});
  EXPECT_TRUE(edges.Meets({5, -5}, {5, 5}));
  EXPECT_TRUE(edges.Meets({10, 0}, {15, 0}));
  EXPECT_FALSE(edges.Meets({11, 0}, {19, 0}));
  EXPECT_FALSE(edges.Meets({15, -5}, {15, 5}));
}

// The number of strips equals the number of edges, not the number of nanometres between them.
TEST(EdgeStrips, OfLevelEdgesFarApart) {
  const EdgeStrips edges =
      StripsOf(std::vector<Segment>{{{0, 0}, {10, 0}}, {{0, 4'000'000'000}, {10, 4'000'000'000}}});
  EXPECT_TRUE(edges.Meets({5, -5}, {5, 5}));
  EXPECT_TRUE(edges.Meets({5, 3'999'999'000}, {5, 4'000'000'001}));
  EXPECT_FALSE(edges.Meets({5, 5}, {5, 3'999'999'000}));
}

}  // namespace
}  // namespace slicefarm::ordering::edge_strips_test
