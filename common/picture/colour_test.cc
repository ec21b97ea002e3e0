#include "common/picture/colour.h"

#include <gtest/gtest.h>

namespace slicefarm::colour_test {
namespace {

double Lightness(const Colour& c) { return 0.3 * c.red + 0.59 * c.green + 0.11 * c.blue; }

TEST(ScaleColour, GrowsLighter) {
  for (int i = 0; i < 20; ++i)
    EXPECT_LT(Lightness(ScaleColour(i / 20.0)), Lightness(ScaleColour((i + 1) / 20.0))) << i;
}

TEST(ScaleColour, EndsAtItsEnds) {
  EXPECT_EQ(ScaleColour(-1).red, ScaleColour(0).red);
  EXPECT_EQ(ScaleColour(2).red, ScaleColour(1).red);
}

}  // namespace
}  // namespace slicefarm::colour_test
