#include "services/planning/algo/seams/seam_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/text_format.h"

namespace slicefarm::planning {
namespace {

using testing::ElementsAre;

MultiPolygon LayerOf(std::string_view text) { return MakePolygonsOrDie(text); }

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

MultiPolygon Disc(Point center, double radius_mm, int points, double phase_rad) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double a = phase_rad + 2 * std::numbers::pi * i / points;
    ring.push_back(center + Mm(radius_mm * std::cos(a), radius_mm * std::sin(a)));
  }
  return {{ring, {}}};
}

TEST(RearMost, TakesTheLeftOfEquals) {
  EXPECT_EQ(RearMost(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")[0].outer), Mm(0, 10));
  EXPECT_EQ(RearMost(MakePolygonsOrDie("(0 0, 10 0, 7 12)")[0].outer), Mm(7, 12));
}

TEST(SeamPenalty, OrdersCorners) {
  // An L: vertex 3 of (5 5) is an inner corner; the middle of the bottom edge is straight.
  const Polygon ring = MakePolygonsOrDie("(0 0, 5 0, 10 0, 10 5, 5 5, 5 10, 0 10)")[0].outer;
  const auto penalty = [&](Point p) {
    return SeamPenaltyMm(ring, std::find(ring.begin(), ring.end(), p) - ring.begin());
  };
  EXPECT_EQ(penalty(Mm(5, 5)), 0);
  EXPECT_EQ(penalty(Mm(10, 5)), 0.5);
  EXPECT_EQ(penalty(Mm(5, 0)), 2);
}

TEST(SeamPenalty, SeesACornerThroughFineFacets) {
  // A right angle rounded by 0.05 mm in 16 facets.
  Polygon ring = MakeLineOrDie("(0 0, 10 0)");
  for (int i = 0; i <= 16; ++i) {
    const double a = std::numbers::pi / 2 * i / 16;
    ring.push_back(Mm(9.95 + 0.05 * std::cos(a), 9.95 + 0.05 * std::sin(a)));
  }
  ring.push_back(Mm(0, 10));
  EXPECT_NEAR(SeamPenaltyMm(ring, 2 + 8), 0.5, 0.01);
}

TEST(SeamChain, StartsAtTheRearOfEqualCorners) {
  EXPECT_THAT(SeamChain().Next(LayerOf("(0 0, 10 0, 10 10, 0 10)")), ElementsAre(Mm(0, 10)));
}

TEST(SeamChain, PrefersAnInnerCorner) {
  EXPECT_THAT(SeamChain().Next(LayerOf("(0 0, 10 0, 10 5, 5 5, 5 10, 0 10)")),
              ElementsAre(Mm(5, 5)));
}

TEST(SeamChain, FollowsACornerThatMoves) {
  SeamChain chain;
  Point want;
  for (int i = 0; i < 20; ++i) {
    const double by = 0.3 * i;
    const MultiPolygon square{{{Mm(by, 0), Mm(10 + by, 0), Mm(10 + by, 10), Mm(by, 10)}, {}}};
    EXPECT_THAT(chain.Next(square), ElementsAre(Mm(by, 10)));
  }
}

TEST(SeamChain, StaysInLineOnARoundPart) {
  // The vertices turn from layer to layer; the seam must not turn along.
  SeamChain chain;
  const Point first = chain.Next(Disc({}, 10, 100, 0))[0];
  for (int i = 1; i < 100; ++i) {
    const Point seam = chain.Next(Disc({}, 10, 100, 0.01 * i))[0];
    EXPECT_LT(Distance(seam, first), FromMm(1.3)) << i;
  }
}

TEST(SeamChain, GivesOneSeamARingHolesIncluded) {
  SeamChain chain;
  const auto layer =
      LayerOf("(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 5 15) ; (30 0, 40 0, 35 9)");
  EXPECT_EQ(chain.Next(layer).size(), 3u);
  EXPECT_EQ(chain.Next(layer), SeamChain().Next(layer)) << "a prism's seams stand upright";
}

TEST(SeamChain, DustDoesNotTakeForever) {
  MultiPolygon dust;
  for (int i = 0; i < 6000; ++i) {
    const Point at{FromMm(i % 80), FromMm(i / 80)};
    dust.push_back({{at, at + Mm(0.5, 0), at + Mm(0.5, 0.5)}, {}});
  }
  SeamChain chain;
  EXPECT_EQ(chain.Next(dust), chain.Next(dust));
}

}  // namespace
}  // namespace slicefarm::planning
