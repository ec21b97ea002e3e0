#include "services/infill/algo/lines/smoothed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"

namespace slicefarm::infill::smoothed_test {
namespace {

constexpr double kLength = 1e6;

/// Returns a wave along x, 200 mm long.
Curve Wave(double wave_mm, double height_mm) {
  Curve curve;
  for (int i = 0; i <= 8000; ++i) {
    const double x = 0.025 * i;
    curve.points.push_back(
        {FromMm(x), FromMm(height_mm * Sin(2 * std::numbers::pi * x / wave_mm))});
  }
  return curve;
}

double HeightInTheMiddle(const Curve& curve) {
  double height = 0;
  for (const Point p : curve.points)
    if (p.x > FromMm(80) && p.x < FromMm(120))
      height = std::max(height, ToMm(static_cast<double>(p.y)));
  return height;
}

// Response of 1 - l^2 D2 + l^4 D4 to a wave: 1 / (1 + a + a^2), a = (2 pi l / wave)^2.
TEST(Smoothed, KeepsOfAWaveWhatTheEquationSays) {
  for (const double wave_mm : {2 * std::numbers::pi, 10.0, 20.0, 40.0}) {
    const double a = 2 * std::numbers::pi / wave_mm * (2 * std::numbers::pi / wave_mm);
    const double height = HeightInTheMiddle(Smoothed(Wave(wave_mm, 0.1), kLength));
    EXPECT_NEAR(height / 0.1, 1 / (1 + a + a * a), 0.07) << wave_mm;
  }
}

TEST(Smoothed, EndsOfAnOpenCurveStay) {
  const Curve bent{{{0, 0}, {FromMm(20), 0}, {FromMm(20), FromMm(20)}}, false};
  const Curve smooth = Smoothed(bent, kLength);
  EXPECT_EQ(smooth.points.front(), bent.points.front());
  EXPECT_EQ(smooth.points.back(), bent.points.back());
  EXPECT_LT(Length(smooth.points), Length(bent.points));
  for (const Point p : smooth.points)
    EXPECT_TRUE(p.x <= FromMm(20.2) && p.y >= FromMm(-0.2)) << p.x << " " << p.y;
}

TEST(Smoothed, ACircleIsPinnedWhereItIs) {
  Curve circle{{}, true};
  for (int i = 0; i < 400; ++i) {
    const double turn = 2 * std::numbers::pi * i / 400;
    circle.points.push_back({FromMm(20 * Cos(turn)), FromMm(20 * Sin(turn))});
  }
  const Curve smoothed = Smoothed(circle, kLength);
  ASSERT_FALSE(smoothed.points.empty());
  // The expected radius follows from the same formula, with a = (l / r)^2.
  for (const Point p : smoothed.points)
    EXPECT_NEAR(ToMm(Distance(p, Point{0, 0})), 20 / (1 + 1.0 / 400), 0.02);
}

TEST(Smoothed, ShortCurvesAndNoLengthChangeNothing) {
  const Curve dot{{{0, 0}, {FromMm(1), 0}, {FromMm(1), FromMm(1)}}, true};
  EXPECT_EQ(Smoothed(dot, kLength).points, dot.points);
  const Curve bent{{{0, 0}, {FromMm(20), 0}, {FromMm(20), FromMm(20)}}, false};
  EXPECT_EQ(Smoothed(bent, 0).points, bent.points);
}

}  // namespace
}  // namespace slicefarm::infill::smoothed_test
