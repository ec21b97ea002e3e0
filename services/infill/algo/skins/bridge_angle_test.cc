#include "services/infill/algo/skins/bridge_angle.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::bridge_angle_test {
namespace {

constexpr Coord kWidth = 450'000;

struct AngleCase {
  std::string name;
  std::string region;
  std::string below;
  double degrees;
  bool held = true;
};

class BridgeAngleTest : public testing::TestWithParam<AngleCase> {};

TEST_P(BridgeAngleTest, SpansTheGap) {
  const AngleCase& c = GetParam();
  const auto span = BridgeAngle(MakePolygonsOrDie(c.region)[0], MakePolygonsOrDie(c.below), kWidth);
  ASSERT_TRUE(span.has_value());
  EXPECT_NEAR(span->angle_rad * 180 / std::numbers::pi, c.degrees, 1e-9);
  EXPECT_EQ(span->held, c.held);
}

INSTANTIATE_TEST_SUITE_P(
    Bridges, BridgeAngleTest,
    testing::Values(AngleCase{"BetweenLegsLeftAndRight", "(9 0, 41 0, 41 20, 9 20)",
                              "(0 0, 10 0, 10 20, 0 20) ; (40 0, 50 0, 50 20, 40 20)", 0},
                    AngleCase{"BetweenLegsBelowAndAbove", "(0 9, 20 9, 20 41, 0 41)",
                              "(0 0, 20 0, 20 10, 0 10) ; (0 40, 20 40, 20 50, 0 50)", 90},
                    AngleCase{"LidOfABoxGoesTheShortWay", "(0 0, 40 0, 40 12, 0 12)",
                              "(-1 -1, 41 -1, 41 13, -1 13) (1 1, 1 11, 39 11, 39 1)", 90},
                    AngleCase{"ShelfOnOneWall", "(9 0, 20 0, 20 40, 9 40)",
                              "(0 0, 10 0, 10 40, 0 40)", 0, false},
                    // The wide part has an unsupported end, but all lines that can be supported at
                    // both ends are.
                    AngleCase{"NarrowerOnOneSide", "(0 -1, 3 -1, 3 14, 8 14, 8 31, 0 31)",
                              "(-1 -9, 9 -9, 9 0, -1 0) ; (-1 30, 9 30, 9 39, -1 39)", 90, false},
                    AngleCase{"BetweenSlantedLegs", "(-1 -1, 29 29, 22 36, -8 6)",
                              "(-2 -2, 4 4, -3 11, -9 5) ; (24 24, 31 31, 24 38, 17 31)", 45}),
    [](const auto& info) { return info.param.name; });

TEST(BridgeAngle, NoneWhereNothingBearsOrAllDoes) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9)");
  EXPECT_FALSE(BridgeAngle(region[0], {}, kWidth));
  EXPECT_FALSE(BridgeAngle(region[0], MakePolygonsOrDie("(20 0, 29 0, 29 9, 20 9)"), kWidth));
  EXPECT_FALSE(BridgeAngle(region[0], MakePolygonsOrDie("(-1 -1, 29 -1, 29 29, -1 29)"), kWidth));
}

}  // namespace
}  // namespace slicefarm::infill::bridge_angle_test
