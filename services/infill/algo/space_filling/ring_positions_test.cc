#include "services/infill/algo/space_filling/ring_positions.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::ring_positions_test {
namespace {

const Polygon& Square() {
  static const Polygon ring = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")[0].outer;
  return ring;
}

TEST(RingPositions, PlacesGoRound) {
  const RingPositions places({&Square()}, 450'000);
  EXPECT_EQ(places.Length(0), 40e6);
  EXPECT_EQ(places.At(0, 0), (Point{0, 0}));
  EXPECT_EQ(places.At(0, 13e6), (Point{10'000'000, 3'000'000}));
  EXPECT_EQ(places.At(0, -1e6), (Point{0, 1'000'000}));
  EXPECT_EQ(places.At(0, 85e6), (Point{5'000'000, 0}));
  EXPECT_EQ(places.Wrapped(0, 40e6), 0);
}

TEST(RingPositions, CornersBetween) {
  const RingPositions places({&Square()}, 450'000);
  const auto corners = [&](double from, double length) {
    std::vector<Point> found;
    places.ForEachCornerBetween(0, from, length, [&](Point p) { found.push_back(p); });
    return found;
  };
  EXPECT_TRUE(corners(1e6, 5e6).empty());
  EXPECT_TRUE(corners(0, 10e6).empty());
  EXPECT_EQ(corners(35e6, 16e6), (std::vector<Point>{{0, 0}, {10'000'000, 0}}));
  EXPECT_EQ(corners(5e6, 40e6).size(), 4U);
}

// The result is compared with a test of all edges of all rings.
TEST(RingPositions, NearestAndNear) {
  std::mt19937 random(3);
  for (int i = 0; i < 30; ++i) {
    std::vector<Polygon> rings;
    for (int k = 0; k < 5; ++k) rings.push_back(RandomStar(random, Uniform(random, 1, 10), 0.3));
    std::vector<const Polygon*> pointers;
    for (const Polygon& ring : rings) pointers.push_back(&ring);
    const RingPositions places(pointers, Uniform(random, 1e5, 3e6));
    for (int k = 0; k < 50; ++k) {
      const Point p = RandomPoint(random, places.Extent());
      const double reach = Uniform(random, 1e5, 4e6);
      std::vector<RingPositions::NearRing> near;
      places.NearRings(
          p, reach, [](int32_t) { return true; }, near);
      for (int32_t ring = 0; ring < 5; ++ring) {
        const double distance = DistanceToBoundary(p, {{rings[ring], {}}});
        const auto nearest = places.Nearest(p, ring, reach);
        const auto found = std::find_if(near.begin(), near.end(),
                                        [&](const auto& one) { return one.ring == ring; });
        ASSERT_EQ(nearest.has_value(), distance <= reach);
        ASSERT_EQ(found != near.end(), distance <= reach);
        if (!nearest) continue;
        EXPECT_NEAR(nearest->distance, distance, 2);
        EXPECT_NEAR(found->distance, distance, 2);
        EXPECT_NEAR(Distance(places.At(ring, nearest->position), p), distance, 2);
      }
    }
  }
}

TEST(SegmentGrid, FindsWhatCrosses) {
  std::mt19937 random(5);
  const Box box{{-8'000'000, 0}, {5'000'000, 9'000'000}};
  SegmentGrid grid(box, 700'000);
  std::vector<std::pair<Point, Point>> segments;
  for (int i = 0; i < 60; ++i) {
    segments.emplace_back(RandomPoint(random, box), RandomPoint(random, box));
    grid.Add(segments[i].first, segments[i].second, i);
  }
  for (int k = 0; k < 300; ++k) {
    const Point p = RandomPoint(random, box);
    std::vector<int> found(segments.size(), 0);
    grid.ForEachNear(p, p, 500'000, [&](int32_t i) { found[i] = 1; });
    for (size_t i = 0; i < segments.size(); ++i)
      if (DistanceToSegment(p, segments[i].first, segments[i].second) <= 500'000) {
        EXPECT_EQ(found[i], 1);
      }
  }
}

}  // namespace
}  // namespace slicefarm::infill::ring_positions_test
