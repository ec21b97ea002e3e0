#include "services/beading/algo/skeleton/skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::beading {
namespace {

Skeleton Of(std::string_view text) { return MakeSkeleton(MakePolygonsOrDie(text)[0], 5'000); }

double WidestMm(const Skeleton& skeleton) {
  double widest = 0;
  for (const SkeletonNode& node : skeleton.nodes) widest = std::max(widest, node.radius);
  return widest / kNmPerMm;
}

TEST(Skeleton, OfASquareIsItsDiagonals) {
  const Skeleton skeleton = Of("(0 0, 2 0, 2 2, 0 2)");
  EXPECT_EQ(skeleton.edges.size(), 4u);
  EXPECT_DOUBLE_EQ(WidestMm(skeleton), 1);
}

TEST(Skeleton, CollinearPointsChangeNothing) {
  const Skeleton plain = Of("(0 0, 5 0, 5 1, 0 1)");
  const Skeleton with = Of("(0 0, 2 0, 3 0, 5 0, 5 1, 4 1, 1 1, 0 1)");
  EXPECT_EQ(plain.edges.size(), with.edges.size());
  EXPECT_EQ(plain.nodes.size(), with.nodes.size());
}

struct BadCase {
  std::string name;
  std::string text;
};
class BadRegion : public testing::TestWithParam<BadCase> {};

TEST_P(BadRegion, GivesNothing) { EXPECT_TRUE(Of(GetParam().text).edges.empty()); }

INSTANTIATE_TEST_SUITE_P(
    Skeleton, BadRegion,
    testing::Values(BadCase{"Crossing", "(0 0, 4 4, 4 0, 0 3)"},
                    BadCase{"HoleCrossesOuter", "(0 0, 4 0, 4 4, 0 4) (3 3, 5 3, 5 5, 3 5)"},
                    BadCase{"HoleTouchesOuterWithACorner", "(0 0, 4 0, 4 4, 0 4) (0 2, 1 1, 1 3)"},
                    BadCase{"CornerTouchesCorner", "(0 0, 2 2, 4 0, 4 4, 2 2, 0 4)"},
                    BadCase{"OverlappingEdges", "(0 0, 4 0, 4 2, 2 2, 2 0, 1 0, 1 1, 0 1)"},
                    BadCase{"Line", "(0 0, 1 0, 2 0)"}),
    [](const auto& info) { return info.param.name; });

// Nodes must be as far from the boundary as they say, and lie inside: on a region with reflex
// corners and a hole.
TEST(Skeleton, RadiusIsTheDistanceToTheBoundary) {
  const PolygonWithHoles region =
      MakePolygonsOrDie("(0 0, 9 0, 9 3, 5 3, 5.5 8, 1 7, 3 4) (6 1, 8 1, 7 2)")[0];
  const Skeleton skeleton = MakeSkeleton(region, 5'000);
  ASSERT_GT(skeleton.edges.size(), 10u);
  std::vector<Polygon> rings = Rings({region});
  for (const SkeletonEdge& edge : skeleton.edges) {
    for (const int i : {edge.a, edge.b}) {
      const SkeletonNode& node = skeleton.nodes[i];
      const Point p = skeleton.origin + Point{std::llround(node.x), std::llround(node.y)};
      double distance = 1e18;
      for (const Polygon& ring : rings)
        for (size_t k = 0; k < ring.size(); ++k)
          distance = std::min(distance, DistanceToSegment(p, ring[k], ring[(k + 1) % ring.size()]));
      EXPECT_NEAR(distance, node.radius, 3'000) << ToText(p);
      EXPECT_NE(Locate(p, region), Side::kOutside);
    }
  }
}

TEST(Skeleton, ParabolasAreWithinTolerance) {
  // A reflex corner over a flat floor: the axis between them is a parabola.
  const Skeleton coarse = MakeSkeleton(MakePolygonsOrDie("(0 0, 8 0, 8 6, 4 1, 0 6)")[0], 100'000);
  const Skeleton fine = MakeSkeleton(MakePolygonsOrDie("(0 0, 8 0, 8 6, 4 1, 0 6)")[0], 1'000);
  EXPECT_LT(coarse.edges.size(), fine.edges.size());
}

TEST(Skeleton, OfARingIsARing) {
  PolygonWithHoles ring;
  Polygon hole;
  for (int i = 0; i < 24; ++i) {
    const double t = 2 * std::numbers::pi * i / 24;
    ring.outer.push_back({FromMm(5 * std::cos(t)), FromMm(5 * std::sin(t))});
    hole.push_back({FromMm(4.5 * std::cos(-t)), FromMm(4.5 * std::sin(-t))});
  }
  ring.holes.push_back(hole);
  EXPECT_NEAR(WidestMm(MakeSkeleton(ring, 5'000)), 0.25, 0.01);
}

}  // namespace
}  // namespace slicefarm::beading
