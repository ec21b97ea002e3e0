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

const PlaceUm kFrom{0, 0};

TEST(RampedTravel, RisesThenGoesOn) {
  const PlaceUm travel[] = {{40'000, 0}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPlace{{10'000, 0}, 1'000}, RampPlace{{40'000, 0}, 1'000}));
}

TEST(RampedTravel, GoesOnRisingRoundCorners) {
  const PlaceUm travel[] = {{4'000, 0}, {4'000, 40'000}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPlace{{4'000, 0}, 400}, RampPlace{{4'000, 6'000}, 1'000},
                          RampPlace{{4'000, 40'000}, 1'000}));
}

TEST(RampedTravel, AShortWayIsNotRisenAllTheWay) {
  const PlaceUm travel[] = {{3'000, 0}};
  EXPECT_THAT(RampedTravel(kFrom, travel, Ramp(), nullptr),
              ElementsAre(RampPlace{{3'000, 0}, 300}));
}

TEST(RampedTravel, IsUpBeforeAnObstacle) {
  RetractionOptions ramp = Ramp();
  const PlaceUm travel[] = {{40'000, 0}};
  const LayerBelow other(MakePolygonsOrDie("(6 -1, 8 -1, 8 1, 6 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &other),
              ElementsAre(RampPlace{{10'000, 0}, 1'000}, RampPlace{{40'000, 0}, 1'000}))
      << "not asked for";
  ramp.before_obstacles = true;
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &other),
              ElementsAre(RampPlace{{6'000, 0}, 1'000}, RampPlace{{40'000, 0}, 1'000}));
  // The nozzle is above an island and moves to another one.
  const LayerBelow both(MakePolygonsOrDie("(-1 -1, 2 -1, 2 1, -1 1) ; (6 -1, 8 -1, 8 1, 6 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &both),
              ElementsAre(RampPlace{{6'000, 0}, 1'000}, RampPlace{{40'000, 0}, 1'000}));
  // The travel leaves its own island and meets no other obstacle.
  const LayerBelow own(MakePolygonsOrDie("(-1 -1, 2 -1, 2 1, -1 1)"));
  EXPECT_THAT(RampedTravel(kFrom, travel, ramp, &own),
              ElementsAre(RampPlace{{10'000, 0}, 1'000}, RampPlace{{40'000, 0}, 1'000}));
}

TEST(RampedTravel, StraightUpWhereTheObstacleIsThere) {
  RetractionOptions ramp = Ramp();
  ramp.before_obstacles = true;
  const PlaceUm travel[] = {{40'000, 0}};
  const LayerBelow edge(MakePolygonsOrDie("(0 -1, 8 -1, 8 1, 0 1)"));
  const std::vector<RampPlace> places = RampedTravel({-1, 0}, travel, ramp, &edge);
  EXPECT_EQ(places.front().up_um, 1'000);
  EXPECT_LE(places.front().place.x, 0);
}

TEST(Lift, IsTheRampsIfThereIsOne) {
  RetractionOptions retraction = Ramp();
  retraction.lift_mm = 0.4;
  EXPECT_EQ(LiftOf(retraction), 1);
  EXPECT_TRUE(RisesAlongTheWay(retraction));
  EXPECT_FALSE(RisesAlongTheWay(Ramp(0)));
  EXPECT_FALSE(RisesAlongTheWay(Ramp(90)));
  retraction.ramping = false;
  EXPECT_EQ(LiftOf(retraction), 0.4);
  EXPECT_FALSE(RisesAlongTheWay(retraction));
}

TEST(SpiralledTravel, RisesOnACircleThatTouchesTheTravel) {
  const PlaceUm travel[] = {{40'000, 0}};
  const std::vector<RampPlace> places = SpiralledTravel(kFrom, travel, Ramp());
  ASSERT_GT(places.size(), 10u);
  const RampPlace top = places[places.size() - 2];
  EXPECT_EQ(top, (RampPlace{kFrom, 1'000})) << "the circle ends where it began";
  EXPECT_EQ(places.back(), (RampPlace{{40'000, 0}, 1'000}));
  double length_um = 0;
  PlaceUm last = kFrom;
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    const auto [place, up_um] = places[i];
    length_um += std::hypot(place.x - last.x, place.y - last.y);
    EXPECT_NEAR(up_um, length_um / 10, 20) << i;
    EXPECT_GE(place.y, -1) << "the circle is on the left of the travel";
    last = place;
  }
  EXPECT_NEAR(length_um, 10'000, 50);
  EXPECT_GT(places.front().place.x, 5 * places.front().place.y) << "it begins along the travel";
}

}  // namespace
}  // namespace slicefarm::motion::travel_ramp_test
