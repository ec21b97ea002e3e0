#include "common/geometry/edge_index.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::edge_index_test {
namespace {

MultiPolygon Star() {
  return MakePolygonsOrDie(
      "(0 0, 20 0, 20 10, 13 4, 9 10, 0 10) (3 3, 3 6, 6 6, 6 3) ; (30 0, 40 3, 31 9)");
}

bool SegmentsMeet(Point a, Point b, Point c, Point d) {
  return Orientation(a, b, c) * Orientation(a, b, d) < 0 &&
         Orientation(c, d, a) * Orientation(c, d, b) < 0;
}

// Compares the index with a search over all edges, for squares of several sizes.
TEST(EdgeIndex, FindsWhatASearchOfAllEdgesFinds) {
  const MultiPolygon region = Star();
  for (const Coord square : {50'000, 700'000, 90'000'000}) {
    const EdgeIndex index(region, square);
    EXPECT_EQ(index.size(), 13);
    std::mt19937 random(1);
    std::uniform_int_distribution<Coord> x(-2'000'000, 42'000'000), y(-2'000'000, 12'000'000);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point a{x(random), y(random)};
      const Point b = i % 2 == 0 ? Point{x(random), y(random)} : a + Point{500'001, 300'007};
      bool meets = false;
      std::set<int32_t> near;
      Box box;
      box.Add(a), box.Add(b);
      index.ForEachNear(box, [&](int32_t e) { near.insert(e); });
      for (int32_t e = 0; e < index.size(); ++e) {
        if (!SegmentsMeet(a, b, index.At(e).a, index.At(e).b)) continue;
        meets = true;
        EXPECT_TRUE(near.contains(e));
      }
      EXPECT_EQ(index.Meets(a, b), meets);
      met += meets ? 1 : 0;
    }
    EXPECT_GT(met, 500);
  }
}

TEST(EdgeIndex, EdgesKnowTheirPlaces) {
  const MultiPolygon region = Star();
  const EdgeIndex index(region, 1'000'000);
  const std::vector<Polygon> rings = Rings(region);
  for (int32_t i = 0; i < index.size(); ++i) {
    const EdgeIndex::Edge& e = index.At(i);
    EXPECT_EQ(rings[static_cast<size_t>(e.ring)][static_cast<size_t>(e.edge)], e.a);
  }
}

TEST(EdgeIndex, OfNothingMeetsNothing) {
  const EdgeIndex index({}, 1'000'000);
  EXPECT_FALSE(index.Meets({0, 0}, {9'000'000, 9}));
}

}  // namespace
}  // namespace slicefarm::edge_index_test
