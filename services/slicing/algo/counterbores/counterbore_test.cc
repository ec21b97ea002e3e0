#include "services/slicing/algo/counterbores/counterbore.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "services/slicing/algo/counterbores/shapes_test.h"

namespace slicefarm::slicing::counterbore_test {
namespace {

using namespace counterbore_shapes_test;  // NOLINT(google-build-using-namespace)

/// Returns a plate of 30 by 30 mm with holes.
MultiPolygon Plate(std::vector<Polygon> holes) {
  PolygonWithHoles plate{Box(-15, -15, 30, 30), {}};
  for (Polygon& hole : holes) plate.holes.push_back(AsHole(std::move(hole)));
  return {plate};
}

/// Checks that all printed material is supported: the part that a layer adds over air must span
/// between two edges of the layer below, along one direction.
void ExpectEachRoomCrossesTheLast(const Counterbore& counterbore) {
  ASSERT_GE(counterbore.open_areas.size(), 2U);
  for (size_t i = 0; i < counterbore.open_areas.size(); ++i) {
    EXPECT_LT(Mm2(Difference(counterbore.holes, counterbore.open_areas[i])), 1e-4);
    if (i > 0) {
      EXPECT_LT(Mm2(Difference(counterbore.open_areas[i], counterbore.open_areas[i - 1])), 1e-4);
    }
  }
}

TEST(CounterboresOver, ARoundHoleOverARoundRecess) {
  const auto found = CounterboresOver(Plate({Disc(0, 0, 3)}), Plate({Disc(0, 0, 1.7)}));
  ASSERT_EQ(found.size(), 1U);
  ExpectEachRoomCrossesTheLast(found[0]);
  ASSERT_EQ(found[0].open_areas.size(), 3U);
  // The first area is a slot (a stripe as wide as the hole across a disc), then follow a square and
  // an octagon.
  const double half = std::asin(1.7 / 3);
  EXPECT_NEAR(Mm2(found[0].open_areas[0]), 3 * 3 * (2 * half + std::sin(2 * half)), 0.1);
  EXPECT_NEAR(Mm2(found[0].open_areas[1]), 3.4 * 3.4, 0.05);
  EXPECT_NEAR(Mm2(found[0].open_areas[2]), 3.4 * 3.4 * 2 * (std::numbers::sqrt2 - 1), 0.05);
  EXPECT_TRUE(Difference(found[0].open_areas[2], Offset(found[0].holes, FromMm(0.2))).empty())
      << "what then lies over air is less than half a bead";
}

TEST(CounterboresOver, ANutTrapIsCrossedWhereBridgesAreShortest) {
  for (const double turn_rad : {0.0, 0.2, 1.1}) {
    const double corner_mm = 5.6 / std::numbers::sqrt3;
    const auto found =
        CounterboresOver(Plate({Ngon(2, 1, corner_mm, 6, turn_rad)}), Plate({Disc(2, 1, 1.6)}));
    ASSERT_EQ(found.size(), 1U) << turn_rad;
    ExpectEachRoomCrossesTheLast(found[0]);
    // The bridge beside the hole is shorter from corner to corner than from flat to flat.
    EXPECT_NEAR(Mm2(found[0].open_areas[0]), 3.2 * (2 * corner_mm - 1.6 / std::numbers::sqrt3),
                0.05);
    EXPECT_NEAR(Mm2(found[0].open_areas[1]), 3.2 * 3.2, 0.05);
  }
}

struct NoneCase {
  std::string name;
  MultiPolygon below, here;
};

TEST(CounterboresOver, OthersAreNone) {
  const std::vector<NoneCase> cases = {
      {"the same hole", Plate({Disc(0, 0, 3)}), Plate({Disc(0, 0, 3)})},
      {"a hole that widens", Plate({Disc(0, 0, 2)}), Plate({Disc(0, 0, 3)})},
      {"a cone, each layer of which rests on the one below", Plate({Disc(0, 0, 3)}),
       Plate({Disc(0, 0, 2.8)})},
      {"a hole that begins in solid", Plate({}), Plate({Disc(0, 0, 2)})},
      {"a recess without a hole", Plate({Disc(0, 0, 3)}), Plate({})},
      {"a hole whose edge rests on one side", Plate({Disc(0, 0, 5)}), Plate({Disc(3.2, 0, 1.7)})},
      {"a layer over nothing", {}, Plate({Disc(0, 0, 3)})},
      {"a ledge, held on one side", {{Box(-15, -15, 10, 30), {}}}, Plate({Disc(5, 0, 2)})},
      {"a boss on one wall of a well, above its bottom", Plate({Box(-10, -10, 20, 20)}),
       Plate({Box(-10, -10, 20, 20)})},
      {"a post in the recess", Plate({Disc(0, 0, 5)}), Plate({Disc(3, 0, 1)})},
  };
  for (NoneCase each : cases) {
    if (each.name == "a post in the recess")
      each.below = Union(each.below, {{Disc(2.5, 0, 1), {}}});
    if (each.name == "a boss on one wall of a well, above its bottom")
      each.here = Union(each.here, {{Box(-4, 4, 8, 8), {AsHole(Disc(0, 7, 1.5))}}});
    EXPECT_TRUE(CounterboresOver(each.below, each.here).empty()) << each.name;
  }
}

TEST(CounterboresOver, ARecessOpenAtASideIsCrossedBetweenItsWalls) {
  // The recess is a slot into which a nut is pushed from the front.
  const MultiPolygon below = Difference(Plate({}), {{Box(-3, -20, 6, 23), {}}});
  const auto found = CounterboresOver(below, Plate({Disc(0, 0, 1.7)}));
  ASSERT_EQ(found.size(), 1U);
  ExpectEachRoomCrossesTheLast(found[0]);
  EXPECT_NEAR(Mm2(found[0].open_areas[0]), 6 * 3.4, 0.05);
}

TEST(CounterboresOver, HolesThatShareARecessAreCrossedAlike) {
  const auto found =
      CounterboresOver(Plate({Box(-10, -4, 20, 8)}), Plate({Disc(-5, 0, 1.5), Disc(5, 0, 1.5)}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].holes.size(), 2U);
  ExpectEachRoomCrossesTheLast(found[0]);
  EXPECT_NEAR(Mm2(found[0].open_areas[0]), 2 * 3 * 8, 0.05) << "two slots, the short way";
  EXPECT_NEAR(Mm2(found[0].open_areas[1]), 2 * 3 * 3, 0.05);
}

TEST(CounterboresOver, ASquareHoleIsDoneInTwoLayers) {
  const auto found = CounterboresOver(Plate({Box(-6, -6, 12, 12)}), Plate({Box(-3, -3, 6, 6)}));
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].open_areas.size(), 2U);
  EXPECT_NEAR(Mm2(found[0].open_areas[0]), 6 * 12, 1e-3);
  EXPECT_NEAR(Mm2(found[0].open_areas[1]), 6 * 6, 1e-3);
}

TEST(CounterboresOver, MovesWithItsPart) {
  const MultiPolygon below = Plate({Disc(1, 2, 4)}), here = Plate({Ngon(1, 2, 1.5, 7)});
  const Point by{FromMm(40), FromMm(-70)};
  const auto found = CounterboresOver(below, here);
  const auto moved = CounterboresOver(Moved(below, by), Moved(here, by));
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(moved.size(), 1U);
  ASSERT_EQ(found[0].open_areas.size(), moved[0].open_areas.size());
  for (size_t i = 0; i < found[0].open_areas.size(); ++i)
    EXPECT_NEAR(Mm2(found[0].open_areas[i]), Mm2(moved[0].open_areas[i]), 1e-4);
}

}  // namespace
}  // namespace slicefarm::slicing::counterbore_test
