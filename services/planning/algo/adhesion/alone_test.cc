#include "services/planning/algo/adhesion/alone.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::planning::alone_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

CopyFootprint Room(int32_t object, Coord x) { return {object, {{x, 10}, {x + 10, 20}}}; }

const MultiPolygon kBed = {{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {}}};

TEST(ObjectsAlone, AreThoseWithRoomAroundAllCopies) {
  EXPECT_THAT(ObjectsAlone(std::vector{Room(0, 10), Room(1, 30), Room(0, 50)}, kBed),
              ElementsAre(0, 1));
}

TEST(ObjectsAlone, OneCopyThatMeetsAnotherIsEnough) {
  EXPECT_THAT(ObjectsAlone(std::vector{Room(0, 10), Room(0, 50), Room(1, 55), Room(2, 80)}, kBed),
              ElementsAre(2));
  EXPECT_THAT(ObjectsAlone(std::vector{Room(0, 10), Room(0, 15)}, kBed), IsEmpty());
}

TEST(ObjectsAlone, NotWhereTheBedEnds) {
  EXPECT_THAT(ObjectsAlone(std::vector{Room(0, 95), Room(1, 30)}, kBed), ElementsAre(1));
}

TEST(ObjectsAlone, NothingTakesNoRoom) {
  EXPECT_THAT(ObjectsAlone(std::vector{CopyFootprint{0, {}}, Room(1, 30)}, kBed), ElementsAre(1));
}

}  // namespace
}  // namespace slicefarm::planning::alone_test
