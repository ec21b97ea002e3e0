#include "services/planning/algo/rings/ring_shape.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::ring_shape_test {
namespace {

using std::numbers::pi;

Polygon RingOf(std::string_view text) { return MakePolygonsOrDie(text)[0].outer; }

Bend BendAt(const RingShape& shape, double along_nm) {
  return shape.BendsAt(std::vector{along_nm})[0];
}

TEST(RingShape, GoesByTheLengthAlong) {
  const Polygon ring = RingOf("(0 0, 10 0, 10 5, 0 5)");
  const RingShape shape(ring);
  EXPECT_EQ(shape.length_nm(), 30e6);
  EXPECT_EQ(shape.AlongTo(2), 15e6);
  const std::vector<Bend> bends = shape.BendsAt(std::vector<double>{0, 12e6, 29.8e6});
  EXPECT_EQ(bends[0].at, Mm(0, 0));
  EXPECT_LE(Distance(bends[0].in, Mm(0, -0.5)), 1) << "from the ring's end";
  EXPECT_LE(Distance(bends[1].at, Mm(10, 2)), 1);
  EXPECT_LE(Distance(bends[2].at, Mm(0, 0.2)), 1);
  EXPECT_LE(Distance(bends[2].out, Mm(0.3, -0.2)), 2) << "beyond the ring's end";
}

TEST(RingShape, TurnsToTheLeftWhereTheSolidSticksOut) {
  const Polygon ring = RingOf("(0 0, 10 0, 10 5, 5 5, 5 10, 0 10)");
  const RingShape shape(ring);
  EXPECT_NEAR(BendAt(shape, 10e6).TurnRad(), pi / 2, 1e-12);
  EXPECT_NEAR(BendAt(shape, 20e6).TurnRad(), -pi / 2, 1e-12);
  EXPECT_NEAR(BendAt(shape, 5e6).TurnRad(), 0, 1e-12);
}

TEST(RingShape, OutwardIsToTheRight) {
  const Polygon ring = RingOf("(0 0, 10 0, 10 5, 0 5)");
  const RingShape shape(ring);
  const auto angle_at = [&](double mm) {
    return OutwardAngleRad(BendAt(shape, mm * 1e6).Outward());
  };
  EXPECT_NEAR(angle_at(5), 1.5 * pi, 0.2);
  EXPECT_NEAR(angle_at(12.5), 0, 0.2);
  EXPECT_NEAR(angle_at(20), 0.5 * pi, 0.2);
  EXPECT_NEAR(angle_at(27.5), pi, 0.2);
}

TEST(RingShape, OutwardIsTheSixteenthOfTheTurnThatTheAngleLiesIn) {
  for (int i = 0; i < 720; ++i) {
    const double angle = (i + 0.5) * pi / 360;  // direction of the ring; outward is 90 degrees less
    const Point arm = Mm(std::cos(angle), std::sin(angle));
    const double outward = angle - pi / 2;
    const auto want = static_cast<int>((outward < 0 ? outward + 2 * pi : outward) / (2 * pi) * 16);
    EXPECT_EQ((Bend{{}, arm, arm}).Outward(), want) << i;
  }
}

TEST(RingShape, FindsCornersThroughFineFacets) {
  // A right angle, rounded by 0.05 mm in 16 facets.
  Polygon ring = MakeLineOrDie("(0 0, 10 0)");
  for (int i = 0; i <= 16; ++i) {
    const double a = pi / 2 * i / 16;
    ring.push_back(Mm(9.95 + 0.05 * std::cos(a), 9.95 + 0.05 * std::sin(a)));
  }
  ring.push_back(Mm(0, 10));
  const RingShape shape(ring);
  const std::vector<Corner> corners = shape.Corners();
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_NEAR(corners[2].turn_rad, pi / 2, 0.1);
  EXPECT_LT(Distance(BendAt(shape, corners[2].along_nm).at, ring[2 + 8]), 1000);
}

TEST(RingShape, ACornerIsWholeWhereverTheRingStarts) {
  // A fillet of 2 mm. Its middle is the corner, independent of the ring's first point.
  Polygon ring = MakeLineOrDie("(20 0, 20 20, 0 20, 0 2)");
  for (int i = 1; i <= 20; ++i) {
    const double a = pi + pi / 2 * i / 20;
    ring.push_back(Mm(2 + 2 * std::cos(a), 2 + 2 * std::sin(a)));
  }
  const Point middle = Mm(2 - std::sqrt(2), 2 - std::sqrt(2));
  for (size_t turn = 0; turn < ring.size(); ++turn) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    const RingShape shape(ring);
    const std::vector<Corner> corners = shape.Corners();
    ASSERT_EQ(corners.size(), 4u) << turn;
    EXPECT_TRUE(std::ranges::any_of(corners, [&](const Corner& corner) {
      return Distance(BendAt(shape, corner.along_nm).at, middle) < 250'000;
    })) << turn;
  }
}

TEST(RingShape, RoundRingsHaveNoCorners) {
  for (const double radius : {0.6, 1.0, 10.0}) {
    const Polygon ring = CircleRing({}, radius, 60);
    EXPECT_TRUE(RingShape(ring).Corners().empty()) << radius;
  }
}

}  // namespace
}  // namespace slicefarm::planning::ring_shape_test
