#include "services/exposure/algo/scan/skins.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::skins_test {
namespace {

double Mm2(const MultiPolygon& region) { return Area(region) / 1e12; }

const MultiPolygon kSquare = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
const MultiPolygon kLeft = MakePolygonsOrDie("(0 0, 4 0, 4 10, 0 10)");
const MultiPolygon kLow = MakePolygonsOrDie("(0 0, 10 0, 10 7, 0 7)");

SkinAreas All(const MultiPolygon& inside) { return {inside, inside, inside}; }

TEST(PartSkins, TheRestIsCore) {
  const std::vector<const MultiPolygon*> above = {&kSquare, &kLeft}, below = {&kLow};
  const SkinAreas areas = PartSkins(All(kSquare), kSquare, {above, below}, 0);
  EXPECT_NEAR(Mm2(areas.downskin), 30, 1e-6);
  EXPECT_NEAR(Mm2(areas.upskin), 42, 1e-6);
  EXPECT_NEAR(Mm2(areas.core), 28, 1e-6);
  EXPECT_TRUE(Intersection(areas.upskin, areas.downskin).empty());
  EXPECT_TRUE(Intersection(areas.core, areas.downskin).empty());
}

TEST(PartSkins, ReachIntoTheRest) {
  const std::vector<const MultiPolygon*> above = {&kLeft};
  const SkinAreas areas = PartSkins(All(kSquare), kSquare, {above, {}}, 500'000);
  EXPECT_NEAR(Mm2(areas.upskin), 65, 1e-6);
  EXPECT_NEAR(Mm2(areas.core), 35, 1e-6);
}

TEST(PartSkins, NoLayerIsAir) {
  const std::vector<const MultiPolygon*> above = {nullptr};
  const SkinAreas areas = PartSkins(All(kSquare), kSquare, {above, {}}, 0);
  EXPECT_NEAR(Mm2(areas.upskin), 100, 1e-6);
  EXPECT_TRUE(areas.core.empty());
}

TEST(PartSkins, APrismHasNone) {
  const std::vector<const MultiPolygon*> same = {&kSquare, &kSquare};
  const SkinAreas areas = PartSkins(All(kLeft), kSquare, {same, same}, 1000);
  EXPECT_EQ(areas.core, kLeft);
  EXPECT_TRUE(areas.upskin.empty() && areas.downskin.empty());
}

TEST(PartSkins, EachKindKeepsToItsOwnInside) {
  const std::vector<const MultiPolygon*> above = {&kLeft}, below = {&kLow};
  const MultiPolygon inner = MakePolygonsOrDie("(1 1, 9 1, 9 9, 1 9)");
  const SkinAreas areas = PartSkins({kSquare, inner, inner}, kSquare, {above, below}, 0);
  EXPECT_NEAR(Mm2(areas.downskin), 16, 1e-6);
  EXPECT_NEAR(Mm2(areas.upskin), 30, 1e-6);
  EXPECT_NEAR(Mm2(areas.core), 28, 1e-6);
}

}  // namespace
}  // namespace slicefarm::exposure::skins_test
