#include "services/infill/algo/patterns/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill {
namespace {

TEST(Surfaces, GyroidLiesOnItsSurface) {
  const double pitch = 2e6, period = 2.4561 * pitch;
  const PatternPlace place{.z_nm = 1'300'000, .pitch_nm = pitch};
  const double z = 2 * std::numbers::pi * 1.3e6 / period;
  const auto pieces = Gyroid(SampleBox(), place);
  ASSERT_GT(pieces->size(), 10u);
  for (const Piece& piece : *pieces) {
    for (size_t i = 1; i < piece.points.size(); ++i) {
      const Point a = piece.points[i - 1], b = piece.points[i];
      const double x = std::numbers::pi * static_cast<double>(a.x + b.x) / period;
      const double y = std::numbers::pi * static_cast<double>(a.y + b.y) / period;
      const double f = std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) +
                       std::sin(z) * std::cos(x);
      const double fx = std::cos(x) * std::cos(y) - std::sin(z) * std::sin(x);
      const double fy = std::cos(y) * std::cos(z) - std::sin(x) * std::sin(y);
      // Distance to first order, where the surface is steep enough to say.
      const double slope = std::hypot(fx, fy);
      if (slope > 0.5) {
        EXPECT_LT(std::abs(f) / slope * period / (2 * std::numbers::pi), 60'000);
      }
    }
  }
}

TEST(Surfaces, SegmentsAreLong) {
  for (MakePattern* pattern : {Gyroid, SchwarzD, FischerKochS}) {
    const auto pieces = pattern(SampleBox(), {.z_nm = 1'300'000, .pitch_nm = 2e6});
    size_t segments = 0;
    for (const Piece& piece : *pieces) segments += piece.points.size() - 1;
    EXPECT_GT(LengthOf(*pieces) / static_cast<double>(segments), 600'000);
  }
}

}  // namespace
}  // namespace slicefarm::infill
