#include "services/planning/algo/adhesion/alone.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::planning::alone_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

CopyFootprint Footprint(int32_t object, Coord x) { return {object, {{x, 10}, {x + 10, 20}}}; }

const MultiPolygon kBed = {{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {}}};

TEST(ObjectsAlone, AreThoseWithRoomAroundAllCopies) {
  EXPECT_THAT(ObjectsAlone(std::vector{Footprint(0, 10), Footprint(1, 30), Footprint(0, 50)}, kBed),
              ElementsAre(0, 1));
}

TEST(ObjectsAlone, OneCopyThatMeetsAnotherIsEnough) {
  EXPECT_THAT(ObjectsAlone(std::vector{Footprint(0, 10), Footprint(0, 50), Footprint(1, 55),
                                       Footprint(2, 80)},
                           kBed),
              ElementsAre(2));
  EXPECT_THAT(ObjectsAlone(std::vector{Footprint(0, 10), Footprint(0, 15)}, kBed), IsEmpty());
}

TEST(ObjectsAlone, NotWhereTheBedEnds) {
  EXPECT_THAT(ObjectsAlone(std::vector{Footprint(0, 95), Footprint(1, 30)}, kBed), ElementsAre(1));
}

TEST(ObjectsAlone, NothingTakesNoRoom) {
  EXPECT_THAT(ObjectsAlone(std::vector{CopyFootprint{0, {}}, Footprint(1, 30)}, kBed),
              ElementsAre(1));
}

}  // namespace
}  // namespace slicefarm::planning::alone_test
