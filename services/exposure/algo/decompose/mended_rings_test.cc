#include "services/exposure/algo/decompose/mended_rings.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::mended_rings_test {
namespace {

size_t Corners(const MultiPolygon& islands) { return PointCount(islands); }

TEST(MendedRings, WhatTouchesNothingStays) {
  const MultiPolygon islands = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  EXPECT_EQ(*MendedRings(islands), islands);
}

TEST(MendedRings, AHoleOfTwoLobesIsPassedWithoutCrossing) {
  const MultiPolygon islands = MakePolygonsOrDie(
      "(0 0, 20 0, 20 20, 0 20) (5 5, 10 5, 10 10, 15 10, 15 15, 10 15, 10 10, 5 10)");
  const auto mended = MendedRings(islands);
  ASSERT_TRUE(mended.ok()) << mended.status();
  EXPECT_EQ(Area(*mended), Area(islands));
  ForEachRing(*mended, [](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      if (ring[i] != Point{10 * kNmPerMm, 10 * kNmPerMm}) continue;
      // At the corner shared by both lobes, the inside is a quarter of the plane.
      const Point before = ring[(i + ring.size() - 1) % ring.size()],
                  after = ring[(i + 1) % ring.size()];
      EXPECT_GT(Cross(ring[i] - before, after - ring[i]), 0);
    }
  });
}

TEST(MendedRings, AnEdgeGetsTheCornerThatTouchesIt) {
  const auto mended =
      MendedRings(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (10 0, 12 10, 8 10)"));
  ASSERT_TRUE(mended.ok());
  EXPECT_EQ(Area(*mended), 380e12);
  EXPECT_EQ(Corners(*mended), 8u);
}

TEST(MendedRings, EdgesThatRunToAndFroAreGone) {
  const auto mended =
      MendedRings(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10) ; (10 0, 20 0, 20 10, 10 10)"));
  ASSERT_TRUE(mended.ok());
  ASSERT_EQ(mended->size(), 1u);
  EXPECT_EQ(Area(*mended), 200e12);
}

TEST(MendedRings, AHoleThatPartsTheRegionMakesTwo) {
  const auto mended =
      MendedRings(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10) (5 0, 6 5, 5 10, 4 5)"));
  ASSERT_TRUE(mended.ok()) << mended.status();
  EXPECT_EQ(mended->size(), 2u);
  EXPECT_EQ(Area(*mended), 90e12);
}

TEST(MendedRings, RefusesCrossings) {
  for (const char* text :
       {"(0 0, 10 0, 10 10, 5 -5)", "(0 0, 10 0, 10 10, 0 10) ; (0 0, 10 0, 10 5, 0 5)"}) {
    const auto mended = MendedRings(MakePolygonsOrDie(text));
    ASSERT_FALSE(mended.ok()) << text;
    EXPECT_EQ(DetailOf(mended.status()).reason, Reason::kRequestMalformed);
  }
}

}  // namespace
}  // namespace slicefarm::exposure::mended_rings_test
