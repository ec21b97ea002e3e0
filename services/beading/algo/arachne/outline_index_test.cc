#include "services/beading/algo/arachne/outline_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::outline_index_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFar = 30e6;

MultiPolygon LayerOf(std::string_view outlines) { return MakePolygonsOrDie(outlines); }

struct PlaceCase {
  std::string name;
  double x_mm, y_mm;
  double distance_mm;
};
class PlaceNearOutlines : public testing::TestWithParam<PlaceCase> {};

// The outlines are a square with a hole, and a triangle beside it.
TEST_P(PlaceNearOutlines, IsAsFarAsTheNearestEdge) {
  const OutlineIndex index(
      LayerOf("(0 0, 10 0, 10 10, 0 10) (4 4, 6 4, 6 6, 4 6) ; (20 0, 24 0, 20 3)"));
  const PlaceCase& place = GetParam();
  EXPECT_NEAR(index.DistanceFrom(place.x_mm * kNmPerMm, place.y_mm * kNmPerMm, kFar) / kNmPerMm,
              place.distance_mm, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    OutlineIndex, PlaceNearOutlines,
    testing::Values(PlaceCase{"Inside", 2, 5, 2}, PlaceCase{"InsideNearTheHole", 3.5, 5, 0.5},
                    PlaceCase{"InTheHole", 5.25, 5, 0.75}, PlaceCase{"Outside", 5, -3, 3},
                    PlaceCase{"OutsideACorner", -3, -4, 5}, PlaceCase{"OnAnEdge", 7, 10, 0},
                    PlaceCase{"OnACorner", 6, 4, 0}, PlaceCase{"ByTheClosingEdge", -1, 5, 1},
                    PlaceCase{"ByTheSecondIsland", 19, 1, 1},
                    PlaceCase{"OffAnIncline", 22 + 3, 1.5 + 4, 5}),
    [](const auto& info) { return info.param.name; });

TEST(OutlineIndex, IsBetweenNanometres) {
  const OutlineIndex index(LayerOf("(0 0, 10 0, 10 10, 0 10)"));
  EXPECT_DOUBLE_EQ(index.DistanceFrom(5e6, 1234.5, kFar), 1234.5);
}

TEST(OutlineIndex, NothingIsInfinitelyFar) {
  EXPECT_EQ(OutlineIndex(MultiPolygon{}).DistanceFrom(0, 0, kFar), kInfinity);
  EXPECT_EQ(OutlineIndex(LayerOf("")).DistanceFrom(0, 0, kFar), kInfinity);
}

TEST(OutlineIndex, KnowsAllObjects) {
  MultiPolygon layer = LayerOf("(0 0, 1 0, 1 1, 0 1) ; (5 0, 6 0, 6 1, 5 1)");
  const OutlineIndex index(layer);
  EXPECT_DOUBLE_EQ(index.DistanceFrom(-1e6, 5e5, kFar), 1e6);
  EXPECT_DOUBLE_EQ(index.DistanceFrom(8e6, 5e5, kFar), 2e6);
}

TEST(OutlineIndex, WhatIsBeyondTheLimitIsInfinitelyFar) {
  const OutlineIndex index(LayerOf("(0 0, 10 0, 10 10, 0 10)"));
  EXPECT_DOUBLE_EQ(index.DistanceFrom(5e6, 2e6, 2e6), 2e6);
  EXPECT_EQ(index.DistanceFrom(5e6, 2e6, 1.9e6), kInfinity);
  EXPECT_EQ(index.DistanceFrom(5e6, -40e6, 1e6), kInfinity);
}

TEST(OutlineIndex, CanBeMoved) {
  OutlineIndex from(LayerOf("(0 0, 1 0, 1 1, 0 1)"));
  OutlineIndex index = std::move(from);
  EXPECT_DOUBLE_EQ(index.DistanceFrom(-1e6, 5e5, kFar), 1e6);
  index = OutlineIndex(MultiPolygon{});
  EXPECT_EQ(index.DistanceFrom(-1e6, 5e5, kFar), kInfinity);
}

// The index accepts rings that are not simple, and both orientations.
TEST(OutlineIndex, AgreesWithAllEdgesOneByOne) {
  std::mt19937 random(1);
  const auto point = [&] {
    return Point{static_cast<Coord>(random() % 10'000'000),
                 static_cast<Coord>(random() % 10'000'000)};
  };
  for (const size_t corners : {3, 10, 300}) {
    Polygon ring;
    for (size_t i = 0; i < corners; ++i) ring.push_back(point());
    const MultiPolygon layer = {{ring, {}}};
    const OutlineIndex index(layer);
    for (int i = 0; i < 200; ++i) {
      const Point place = point();
      double nearest = kInfinity;
      for (size_t edge = 0; edge < corners; ++edge) {
        nearest =
            std::min(nearest, DistanceToSegment(place, ring[edge], ring[(edge + 1) % corners]));
      }
      EXPECT_NEAR(
          index.DistanceFrom(static_cast<double>(place.x), static_cast<double>(place.y), kFar),
          nearest, 0.01);
    }
  }
}

}  // namespace
}  // namespace slicefarm::beading::outline_index_test
