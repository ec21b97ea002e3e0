#include "services/beading/algo/noise/skin_noise.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/model/paths_test.h"

namespace slicefarm::beading::skin_noise_test {
namespace {

Path Square(std::string_view points) {
  Path path = MakePathOrDie(points);
  path.closed = true;
  return path;
}

TEST(TextureNoise, HasTheSizeOfTheSetting) {
  FuzzyTexture fine{.noise = FuzzyNoise::kPerlin, .scale_mm = 1};
  FuzzyTexture coarse = fine;
  coarse.scale_mm = 5;
  const Point at{1'300'000, 700'000}, five{6'500'000, 3'500'000};
  EXPECT_EQ(TextureNoise(fine, at, 400'000), TextureNoise(coarse, five, 2'000'000));
  EXPECT_NE(TextureNoise(fine, at, 400'000), TextureNoise(fine, at, 600'000));
}

// A wall around the origin crosses the x axis at -10 mm, 70 mm from its first point.
TEST(Ripples, BeginWithACrestAtTheLeftmostCrossing) {
  const Path wall = Square("(-10 -10, 10 -10, 10 10, -10 10)");
  const FuzzyTexture texture{.noise = FuzzyNoise::kRipple, .ripples = 8};
  const Ripples ripples(texture, wall, 0);
  EXPECT_NEAR(ripples.At(70e6), 1, 1e-9);
  EXPECT_NEAR(ripples.At(75e6), -1, 1e-9);  // half a wave of 10 mm
  EXPECT_NEAR(ripples.At(0), ripples.At(80e6), 1e-9);
}

TEST(Ripples, ShiftFromGroupToGroupOfLayers) {
  const Path wall = Square("(-10 -10, 10 -10, 10 10, -10 10)");
  FuzzyTexture texture{.noise = FuzzyNoise::kRipple, .ripples = 8, .ripple_layers = 3};
  const auto crest = [&](int32_t layer) { return Ripples(texture, wall, layer).At(70e6); };
  EXPECT_NEAR(crest(2), 1, 1e-9);
  EXPECT_NEAR(crest(3), -1, 1e-9);
  EXPECT_NEAR(crest(6), 1, 1e-9);
  texture.ripple_shift = 0.25;
  EXPECT_NEAR(crest(3), 0, 1e-9);
}

// Waves of a wall beside the axis begin at the nearest corner.
TEST(Ripples, BeginAtTheNearestCornerBesideTheAxis) {
  const Path wall = Square("(0 20, 10 5, 20 20)");
  const FuzzyTexture texture{.noise = FuzzyNoise::kRipple, .ripples = 3};
  EXPECT_NEAR(Ripples(texture, wall, 0).At(Distance(wall.points[0], wall.points[1])), 1, 1e-9);
}

}  // namespace
}  // namespace slicefarm::beading::skin_noise_test
