#include "services/planning/algo/adhesion/automatic_brim.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::automatic_brim_test {
namespace {

struct AutomaticCase {
  const char* name;
  const char* outlines;
  double height_mm;
  AutomaticBrim brim;
  double width_mm;
};

class AutomaticBrimTest : public testing::TestWithParam<AutomaticCase> {};

TEST_P(AutomaticBrimTest, WidthInMm) {
  const AutomaticCase& c = GetParam();
  const Coord width =
      AutomaticBrimWidth(c.brim, MakePolygonsOrDie(c.outlines), FromMm(c.height_mm));
  EXPECT_NEAR(static_cast<double>(width) / 1e6, c.width_mm, 0.02);
}

constexpr char kBlock[] = "(0 0, 20 0, 20 20, 0 20)";
const AutomaticBrim kPla{true, 200, 1, 200};

// The second moment of a square of side a is a^4 / 12. For a block of 20 mm and height h the width
// against falling over is h / 13333 * 20 * h / 1920 * 200 = h^2 / 6400. The width against warping
// is 28.3 * 8 / 200 = 1.1 mm.
INSTANTIATE_TEST_SUITE_P(
    Shapes, AutomaticBrimTest,
    testing::Values(
        AutomaticCase{"LowBlock", kBlock, 20, kPla, 0},
        AutomaticCase{"TallBlock", kBlock, 200, kPla, 6.25},
        AutomaticCase{"TallerBlock", kBlock, 300, kPla, 14.06},
        AutomaticCase{"NoMoreThan18", kBlock, 390, kPla, 18},
        AutomaticCase{"Slowly", kBlock, 200, {true, 200, 1, 50}, 0},
        AutomaticCase{"Elsewhere", "(100 -50, 120 -50, 120 -30, 100 -30)", 200, kPla, 6.25},
        AutomaticCase{"LongOfPc", "(0 0, 80 0, 80 60, 0 60)", 30, {true, 40, 1, 60}, 18},
        AutomaticCase{"LongOfAbs", "(0 0, 80 0, 80 60, 0 60)", 30, {true, 100, 1, 60}, 8},
        AutomaticCase{"LongOfPla", "(0 0, 80 0, 80 60, 0 60)", 30, kPla, 0},
        AutomaticCase{"HoldsTwiceAsBad", "(0 0, 80 0, 80 60, 0 60)", 30, {true, 200, 2, 60}, 8},
        AutomaticCase{"PinNoWiderThanItself", "(0 0, 2 0, 2 2, 0 2)", 30, kPla, 2},
        AutomaticCase{"ThinTallWall", "(0 0, 40 0, 40 1, 0 1)", 11, {true, 200, 1, 10}, 5},
        AutomaticCase{"ThinLowWall", "(0 0, 40 0, 40 1, 0 1)", 9, {true, 200, 1, 10}, 0}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(AutomaticBrimWidth, HolesAreTakenOff) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (1 1, 1 19, 19 19, 19 1)");
  const MultiPolygon block = MakePolygonsOrDie(kBlock);
  EXPECT_GT(AutomaticBrimWidth(kPla, frame, FromMm(250)),
            AutomaticBrimWidth(kPla, block, FromMm(250)));
  EXPECT_EQ(AutomaticBrimWidth(kPla, {}, FromMm(250)), 0);
}

}  // namespace
}  // namespace slicefarm::planning::automatic_brim_test
