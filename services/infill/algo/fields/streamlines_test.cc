#include "services/infill/algo/fields/streamlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/fields/field_samples_test.h"

namespace slicefarm::infill::streamlines_test {
namespace {

constexpr double kSide = 64;

/// Returns stresses with the greater principal direction (u, v), over [0, kSide]^2.
StressField Along(const std::function<std::pair<double, double>(double, double)>& direction) {
  StressField stress;
  const auto part = [&](auto product) {
    return GridOf(65, kSide, [&](double x, double y) {
      const auto [u, v] = direction(x, y);
      const double norm = std::max(1e-9, std::sqrt(u * u + v * v));
      return product(u / norm, v / norm);
    });
  };
  stress.xx = part([](double u, double) { return u * u; });
  stress.yy = part([](double, double v) { return v * v; });
  stress.xy = part([](double u, double v) { return u * v; });
  return stress;
}

std::vector<Curve> Lines(const StressField& stress, double separation_mm) {
  const DirectionField directions(stress);
  auto curves = Streamlines({0, 0, kSide, kSide}, directions,
                            {.separation_mm = [=](double, double) { return separation_mm; }});
  EXPECT_TRUE(curves.ok());
  return *std::move(curves);
}

struct Sample {
  Point at;
  double dx, dy;  ///< direction of the line at the sample
  size_t line;
};

std::vector<Sample> SamplesOf(const std::vector<Curve>& curves, double step_mm) {
  std::vector<Sample> samples;
  for (size_t line = 0; line < curves.size(); ++line) {
    const Polyline& points = curves[line].points;
    const size_t count = points.size() - (curves[line].closed ? 0 : 1);
    for (size_t i = 0; i < count; ++i) {
      const Point a = points[i], b = points[(i + 1) % points.size()];
      const double length = ToMm(Distance(a, b));
      const int steps = std::max(1, static_cast<int>(std::ceil(length / step_mm)));
      for (int k = 0; k < steps; ++k) {
        const double share = (k + 0.5) / steps;
        samples.push_back({{a.x + std::llround(share * static_cast<double>(b.x - a.x)),
                            a.y + std::llround(share * static_cast<double>(b.y - a.y))},
                           ToMm(b.x - a.x) / length,
                           ToMm(b.y - a.y) / length,
                           line});
      }
    }
  }
  return samples;
}

/// Returns the root mean square of the angle between lines and the requested direction, in degrees.
double AngleRms(const std::vector<Sample>& samples,
                const std::function<std::pair<double, double>(double, double)>& direction,
                const std::function<bool(double, double)>& counts) {
  double sum = 0, all = 0;
  for (const Sample& sample : samples) {
    const double x = ToMm(sample.at.x), y = ToMm(sample.at.y);
    if (!counts(x, y)) continue;
    const auto [u, v] = direction(x, y);
    const double sine = std::abs(sample.dx * v - sample.dy * u) / std::hypot(u, v);
    const double degrees = std::asin(std::min(1.0, sine)) * 180 / std::numbers::pi;
    sum += degrees * degrees, all += 1;
  }
  EXPECT_GT(all, 100);
  return std::sqrt(sum / all);
}

/// Returns the share of the length, away from the box's edge, that has a neighbour on each side at
/// 0.8 to 1.2 of the separation. A ray across the line finds the next line.
double EvenShare(const std::vector<Curve>& curves, double separation_mm,
                 const std::function<bool(double, double)>& counts) {
  double even = 0, all = 0;
  for (const Sample& sample : SamplesOf(curves, 1)) {
    const double x = ToMm(sample.at.x), y = ToMm(sample.at.y);
    if (!counts(x, y)) continue;
    for (const double side : {-1.0, 1.0}) {
      const double nx = -sample.dy * side, ny = sample.dx * side;
      double nearest = 1e9;
      for (size_t line = 0; line < curves.size(); ++line) {
        const Polyline& points = curves[line].points;
        for (size_t i = 1; i < points.size() + (curves[line].closed ? 1 : 0); ++i) {
          const Point p = points[i - 1], q = points[i % points.size()];
          const double ax = ToMm(p.x) - x, ay = ToMm(p.y) - y, bx = ToMm(q.x) - x,
                       by = ToMm(q.y) - y;
          const double ca = nx * ay - ny * ax, cb = nx * by - ny * bx;
          if ((ca > 0) == (cb > 0)) continue;
          const double t = ca / (ca - cb);
          const double away = nx * (ax + t * (bx - ax)) + ny * (ay + t * (by - ay));
          if (away > 1e-3) nearest = std::min(nearest, away);
        }
      }
      all += 1;
      even += nearest > 0.8 * separation_mm && nearest < 1.2 * separation_mm;
    }
  }
  EXPECT_GT(all, 100);
  return even / all;
}

bool Inner(double x, double y) { return x > 4 && y > 4 && x < kSide - 4 && y < kSide - 4; }

TEST(Streamlines, OfAConstantFieldAreParallelLines) {
  const auto aslant = [](double, double) { return std::pair(0.8, 0.6); };
  const auto curves = Lines(Along(aslant), 2);
  EXPECT_LT(AngleRms(SamplesOf(curves, 0.5), aslant, Inner), 0.05);
  EXPECT_GT(EvenShare(curves, 2, Inner), 0.99);
}

TEST(Streamlines, OfCirclesClose) {
  const auto around = [](double x, double y) { return std::pair(-(y - 32), x - 32); };
  const auto away = [](double x, double y) {
    return std::hypot(x - 32, y - 32) > 5 && Inner(x, y);
  };
  const auto curves = Lines(Along(around), 2);
  EXPECT_LT(AngleRms(SamplesOf(curves, 0.5), around, away), 2);
  EXPECT_GT(EvenShare(curves, 2, away), 0.95);
  size_t closed = 0;
  for (const Curve& curve : curves) closed += curve.closed;
  EXPECT_GE(closed, 10u);
}

TEST(Streamlines, ThatBendKeepTheirDistance) {
  const auto bent = [](double x, double) { return std::pair(1.0, 0.5 * std::cos(x / 10)); };
  const auto curves = Lines(Along(bent), 2);
  EXPECT_LT(AngleRms(SamplesOf(curves, 0.5), bent, Inner), 2);
  // Lines that are parallel along y are nearer to each other where they are steep: 0.89 of the
  // separation.
  EXPECT_GT(EvenShare(curves, 2, Inner), 0.95);
}

/// Returns the stresses of a plate under tension along x, around a hole of `radius` in its middle
/// (Kirsch).
StressField AroundHole(double radius) {
  StressField stress;
  std::array<FieldGrid*, 3> parts = {&stress.xx, &stress.yy, &stress.xy};
  for (size_t part = 0; part < 3; ++part) {
    *parts[part] = GridOf(65, kSide, [&](double x_mm, double y_mm) {
      const double x = x_mm - kSide / 2, y = y_mm - kSide / 2;
      const double r = std::max(std::hypot(x, y), radius), turn = std::atan2(y, x);
      const double q = radius * radius / (r * r), c = std::cos(turn), s = std::sin(turn);
      const double rr = 0.5 * (1 - q) + 0.5 * (1 - 4 * q + 3 * q * q) * std::cos(2 * turn);
      const double tt = 0.5 * (1 + q) - 0.5 * (1 + 3 * q * q) * std::cos(2 * turn);
      const double rt = -0.5 * (1 + 2 * q - 3 * q * q) * std::sin(2 * turn);
      return std::array{rr * c * c + tt * s * s - 2 * rt * s * c,
                        rr * s * s + tt * c * c + 2 * rt * s * c,
                        (rr - tt) * s * c + rt * (c * c - s * s)}[part];
    });
  }
  return stress;
}

TEST(Streamlines, KeepTheirDistanceBesideAHole) {
  const StressField stress = AroundHole(8);
  const DirectionField field(stress);
  const auto away = [](double x, double y) {
    return std::hypot(x - kSide / 2, y - kSide / 2) > 16 && Inner(x, y);
  };
  const auto along = [&](double x, double y) {
    const Vector2 direction = field.At({x, y, 0}).value();
    return std::pair(direction.x(), direction.y());
  };
  const auto curves = Lines(stress, 2);
  EXPECT_LT(AngleRms(SamplesOf(curves, 0.5), along, away), 2);
  EXPECT_GT(EvenShare(curves, 2, away), 0.86);
}

/// Returns the stresses of a beam that is fixed at x = 0 and loaded at its other end. It is under
/// tension above its middle, under compression below, and has the greatest shear in the middle.
/// This is the closed-form solution of a slender beam.
std::array<double, 3> BeamAt(double x, double y) {
  const double half = kSide / 4, up = y - half;
  return {(kSide - x) * up, 0, -(half * half - up * up) / 2};
}

StressField Beam(int nodes) {
  StressField stress;
  std::array<FieldGrid*, 3> parts = {&stress.xx, &stress.yy, &stress.xy};
  for (size_t part = 0; part < 3; ++part)
    *parts[part] = GridOf(nodes, kSide, [&](double x, double y) { return BeamAt(x, y)[part]; });
  return stress;
}

/// Returns the direction of the stress of greater magnitude, by power iteration, which uses no
/// angles.
std::pair<double, double> GreatestPull(double x, double y) {
  const auto [xx, yy, xy] = BeamAt(x, y);
  double u = 0.83, v = 0.56;
  for (int i = 0; i < 3'000; ++i) {
    const double a = xx * u + xy * v, b = xy * u + yy * v, norm = std::hypot(a, b);
    if (norm == 0) break;
    u = a / norm, v = b / norm;
  }
  return {u, v};
}

// The test covers the two families of directions: each layer follows one of them.
TEST(Streamlines, OfABeamFollowTheGreaterStressAndTheOther) {
  for (const int nodes : {65, 33}) {
    const DirectionField directions(Beam(nodes));
    for (const double separation : {1.0, 2.0, 3.0}) {
      for (const bool across : {false, true}) {
        const auto curves = Streamlines(
            {0, 0, kSide, kSide / 2}, directions,
            {.across = across, .separation_mm = [=](double, double) { return separation; }});
        ASSERT_TRUE(curves.ok());
        const auto asked = [&](double x, double y) {
          const auto [u, v] = GreatestPull(x, y);
          return across ? std::pair(-v, u) : std::pair(u, v);
        };
        // In the middle the two directions are exchanged, from one node of the field to the next.
        const auto counts = [&](double x, double y) {
          return x > 3 && x < kSide - 3 && y > 3 && y < kSide / 2 - 3 &&
                 std::abs(y - kSide / 4) > 2 * kSide / (nodes - 1);
        };
        const auto samples = SamplesOf(*curves, 0.25);
        const std::string name = std::to_string(nodes) + ", " + std::to_string(separation) +
                                 (across ? " across" : " along");
        EXPECT_LT(AngleRms(samples, asked, counts), 2) << name;
        double length = 0;
        for (const Curve& curve : *curves)
          length += ToMm(Length(curve.points)) +
                    (curve.closed ? ToMm(Distance(curve.points.back(), curve.points.front())) : 0);
        EXPECT_NEAR(length * separation / (kSide * kSide / 2), 1, 0.03) << name;
      }
    }
  }
}

TEST(Streamlines, LeaveNoGapOfTwoSeparations) {
  const auto spread = [](double x, double y) { return std::pair(x + 5, y - 32); };  // radial
  const auto curves = Lines(Along(spread), 2);
  const auto samples = SamplesOf(curves, 0.25);
  for (double y = 4; y < 60; y += 1.3) {
    for (double x = 4; x < 60; x += 1.3) {
      double nearest = 1e9;
      for (const Sample& sample : samples)
        nearest = std::min(nearest, std::hypot(ToMm(sample.at.x) - x, ToMm(sample.at.y) - y));
      EXPECT_LT(nearest, 2.1) << x << ", " << y;
    }
  }
}

// No part stays empty because it has no stress.
TEST(Streamlines, GoOnWhereThereIsNoStress) {
  // The left half has the direction x, the right half has no direction at all.
  StressField stress = Along([](double, double) { return std::pair(1.0, 0.0); });
  for (size_t i = 0; i < stress.xx.values.size(); ++i)
    if (i % 65 > 40) stress.xx.values[i] = stress.yy.values[i] = 1, stress.xy.values[i] = 0;
  stress.smoothing = 0;
  EXPECT_EQ(Lines(stress, 2).size(),
            Lines(Along([](double, double) { return std::pair(1.0, 0.0); }), 2).size());
  for (const Curve& curve : Lines(stress, 2)) {
    EXPECT_LT(ToMm(curve.points.front().x), 1);
    EXPECT_GT(ToMm(curve.points.back().x), 63);
  }
}

// One half has the direction x, one half the direction y. Between them the directions cancel.
TEST(Streamlines, StopAtDegeneratePlaces) {
  StressField stress = Along([](double, double) { return std::pair(1.0, 0.0); });
  for (size_t i = 0; i < stress.xx.values.size(); ++i)
    if (i % 65 > 40) std::swap(stress.xx.values[i], stress.yy.values[i]);
  stress.smoothing = 0;
  const auto lines = Lines(stress, 2);
  ASSERT_FALSE(lines.empty());
  for (const Curve& curve : lines) {
    EXPECT_EQ(ToMm(curve.points.front().x) < 40.5, ToMm(curve.points.back().x) < 40.6);
  }
}

TEST(Streamlines, AreCloserWhereTheSeparationIsSmaller) {
  const DirectionField directions(Along([](double, double) { return std::pair(1.0, 0.0); }));
  const auto curves =
      Streamlines({0, 0, kSide, kSide}, directions,
                  {.separation_mm = [](double, double y) { return y < 32 ? 1 : 4; }});
  ASSERT_TRUE(curves.ok());
  std::vector<Polyline> lines;
  for (const Curve& curve : *curves) lines.push_back(curve.points);
  const auto halves = LengthByCell(lines, kSide, 32);
  EXPECT_NEAR((halves[0] + halves[1]) / (64 * 32), 1, 0.1);
  EXPECT_NEAR((halves[2] + halves[3]) / (64 * 32), 0.25, 0.04);
}

TEST(Streamlines, RefuseBoxesOfTooManyCells) {
  const DirectionField directions(Along([](double, double) { return std::pair(1.0, 0.0); }));
  const auto lines = Streamlines({0, 0, 2000, 2000}, directions,
                                 {.separation_mm = [](double, double) { return 1; }});
  EXPECT_EQ(DetailOf(lines.status()).reason, Reason::kRequestTooLarge);
}

TEST(Streamlines, AreNoneWhereNothingIsAsked) {
  const DirectionField directions(Along([](double, double) { return std::pair(1.0, 0.0); }));
  const auto none = Streamlines({0, 0, kSide, kSide}, directions,
                                {.separation_mm = [](double, double) { return 0; }});
  ASSERT_TRUE(none.ok());
  EXPECT_TRUE(none->empty());
}

}  // namespace
}  // namespace slicefarm::infill::streamlines_test
