#include "services/motion/algo/toolpath/travel_ramp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/text_format_test.h"

namespace slicefarm::motion::travel_ramp_test {
namespace {

using ::testing::ElementsAre;

/// Returns a ramp of 1 mm up over 10 mm.
RetractionOptions Ramp(double slope_deg = 5.710593137499643) {
  RetractionOptions retraction;
  retraction.ramping = true;
  retraction.ramp_lift_mm = 1;
  retraction.ramp_slope_deg = slope_deg;
  return retraction;
}

const PointUm kFrom{0, 0};

TEST(RampedTravel, RisesThenGoesOn) {
  const PointUm travel[] = {{40'000, 0}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPoint{{10'000, 0}, 1'000}, RampPoint{{40'000, 0}, 1'000}));
}

TEST(RampedTravel, GoesOnRisingRoundCorners) {
  const PointUm travel[] = {{4'000, 0}, {4'000, 40'000}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPoint{{4'000, 0}, 400}, RampPoint{{4'000, 6'000}, 1'000},
                          RampPoint{{4'000, 40'000}, 1'000}));
}

TEST(RampedTravel, AShortWayIsNotRisenAllTheWay) {
  const PointUm travel[] = {{3'000, 0}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPoint{{3'000, 0}, 300}));
}

TEST(RampedTravel, IsUpBeforeAnObstacle) {
  RetractionOptions ramp = Ramp();
  const PointUm travel[] = {{40'000, 0}};
  const LayerBelow other(MakePolygonsOrDie("(6 -1, 8 -1, 8 1, 6 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &other),
              ElementsAre(RampPoint{{10'000, 0}, 1'000}, RampPoint{{40'000, 0}, 1'000}))
      << "not asked for";
  ramp.before_obstacles = true;
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &other),
              ElementsAre(RampPoint{{6'000, 0}, 1'000}, RampPoint{{40'000, 0}, 1'000}));
  // The nozzle is above an island and moves to another one.
  const LayerBelow both(MakePolygonsOrDie("(-1 -1, 2 -1, 2 1, -1 1) ; (6 -1, 8 -1, 8 1, 6 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &both),
              ElementsAre(RampPoint{{6'000, 0}, 1'000}, RampPoint{{40'000, 0}, 1'000}));
  // The travel leaves its own island and meets no other obstacle.
  const LayerBelow own(MakePolygonsOrDie("(-1 -1, 2 -1, 2 1, -1 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &own),
              ElementsAre(RampPoint{{10'000, 0}, 1'000}, RampPoint{{40'000, 0}, 1'000}));
}

TEST(RampedTravel, StraightUpWhereTheObstacleIsThere) {
  RetractionOptions ramp = Ramp();
  ramp.before_obstacles = true;
  const PointUm travel[] = {{40'000, 0}};
  const LayerBelow edge(MakePolygonsOrDie("(0 -1, 8 -1, 8 1, 0 1)"));
  const std::vector<RampPoint> points = RampedTravel({-1, 0}, travel, ramp, &edge);
  EXPECT_EQ(points.front().up_um, 1'000);
  EXPECT_LE(points.front().point.x, 0);
}

TEST(Lift, IsTheRampsIfThereIsOne) {
  RetractionOptions retraction = Ramp();
  retraction.lift_mm = 0.4;
  EXPECT_EQ(LiftOf(retraction), 1);
  EXPECT_TRUE(RisesAlongTravel(retraction));
  EXPECT_FALSE(RisesAlongTravel(Ramp(0)));
  EXPECT_FALSE(RisesAlongTravel(Ramp(90)));
  retraction.ramping = false;
  EXPECT_EQ(LiftOf(retraction), 0.4);
  EXPECT_FALSE(RisesAlongTravel(retraction));
}

TEST(SpiralledTravel, RisesOnACircleThatTouchesTheTravel) {
  const PointUm travel[] = {{40'000, 0}};
  const std::vector<RampPoint> points = SpiralledTravel(kFrom, travel, Ramp());
  ASSERT_GT(points.size(), 10u);
  const RampPoint top = points[points.size() - 2];
  EXPECT_EQ(top, (RampPoint{kFrom, 1'000})) << "the circle ends where it began";
  EXPECT_EQ(points.back(), (RampPoint{{40'000, 0}, 1'000}));
  double length_um = 0;
  PointUm last = kFrom;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const auto [point, up_um] = points[i];
    length_um += std::hypot(point.x - last.x, point.y - last.y);
    EXPECT_NEAR(up_um, length_um / 10, 20) << i;
    EXPECT_GE(point.y, -1) << "the circle is on the left of the travel";
    last = point;
  }
  EXPECT_NEAR(length_um, 10'000, 50);
  EXPECT_GT(points.front().point.x, 5 * points.front().point.y) << "it begins along the travel";
}

}  // namespace
}  // namespace slicefarm::motion::travel_ramp_test
