#include "services/infill/algo/patterns/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::surfaces_test {
namespace {

struct Surface {
  MakePattern* make;
  double period;  ///< period in pitches
  double (*value)(double x, double y, double z);
};

double GyroidAt(double x, double y, double z) {
  return std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
}
double SchwarzDAt(double x, double y, double z) {
  return std::cos(x) * std::cos(y) * std::cos(z) - std::sin(x) * std::sin(y) * std::sin(z);
}
double FischerKochSAt(double x, double y, double z) {
  return std::cos(2 * x) * std::sin(y) * std::cos(z) + std::cos(2 * y) * std::sin(z) * std::cos(x) +
         std::cos(2 * z) * std::sin(x) * std::cos(y);
}

/// Returns the distance from (x, y) to the zero line of `value`, by Newton's method across the
/// line.
double PathToZero(double (*value)(double, double, double), double x, double y, double z) {
  constexpr double kStep = 1e-6;
  const double x0 = x, y0 = y;
  for (int step = 0; step < 5; ++step) {
    const double f = value(x, y, z);
    const double dx = (value(x + kStep, y, z) - f) / kStep;
    const double dy = (value(x, y + kStep, z) - f) / kStep;
    x -= f * dx / (dx * dx + dy * dy);
    y -= f * dy / (dx * dx + dy * dy);
  }
  return std::hypot(x - x0, y - y0);
}

// The middles of segments are tested, where the surface is steep enough for a clear result.
TEST(Surfaces, LinesLieOnTheirSurface) {
  constexpr double kPitch = 2e6, kStep = 1e-6;
  for (const auto& [make, pitches, value] :
       {Surface{Gyroid, 2.4561, GyroidAt}, Surface{SchwarzD, 3.043, SchwarzDAt},
        Surface{FischerKochS, 4.264, FischerKochSAt}}) {
    const double turn = 2 * std::numbers::pi / (pitches * kPitch);
    const double z = 1.3e6 * turn;
    const auto pieces = make(SampleBox(), {.z_nm = 1'300'000, .pitch_nm = kPitch});
    ASSERT_GT(pieces->size(), 10u);
    int steep = 0, all = 0;
    for (const Piece& piece : *pieces) {
      for (size_t i = 1; i < piece.points.size(); ++i) {
        const Point a = piece.points[i - 1], b = piece.points[i];
        const double x = turn * static_cast<double>(a.x + b.x) / 2;
        const double y = turn * static_cast<double>(a.y + b.y) / 2;
        const double f = value(x, y, z);
        const double slope =
            std::hypot(value(x + kStep, y, z) - f, value(x, y + kStep, z) - f) / kStep;
        ++all;
        if (slope < 0.5) continue;
        ++steep;
        EXPECT_LT(PathToZero(value, x, y, z) / turn, 50'500) << pitches;
      }
    }
    EXPECT_GT(steep, all / 2) << pitches;
  }
}

/// Returns the mean length of a gyroid's lines in its layers over a period, as a share of the
/// length that the pitch asks for.
double LengthOfGyroid(double waves, double angle_rad) {
  constexpr double kPitch = 2e6;
  constexpr int kLayers = 12;
  const auto area = MakePolygonsOrDie("(0 0, 120 0, 120 120, 0 120)");
  const double x = std::log(waves);
  const double period =
      2.4561 * kPitch * std::cbrt(waves) * (1 + x * (0.16662 + x * (0.21882 + x * 0.034856)));
  double length = 0;
  for (int i = 0; i < kLayers; ++i) {
    PatternContext context{
        .z_nm = std::llround(period * i / kLayers), .pitch_nm = kPitch, .angle_rad = angle_rad};
    context.shape.gyroid_waves = waves;
    const auto pieces = Gyroid(area, context);
    for (const Piece& piece : *pieces) {
      length += Length(piece.points);
      if (piece.closed) length += Distance(piece.points.back(), piece.points.front());
    }
  }
  return length / kLayers * kPitch / Area(area);
}

// A stiff gyroid has as much length per area as a plain one, in any direction.
TEST(Surfaces, StiffGyroidsKeepTheirDensity) {
  const double plain = LengthOfGyroid(1, 0);
  EXPECT_NEAR(plain, 1, 0.03);
  for (const double waves : {0.55, 0.8, 1.4})
    for (const double angle_rad : {0.0, 0.6})
      EXPECT_NEAR(LengthOfGyroid(waves, angle_rad) / plain, 1, 0.01) << waves << " " << angle_rad;
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
}  // namespace slicefarm::infill::surfaces_test
