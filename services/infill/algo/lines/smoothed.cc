#include "services/infill/algo/lines/smoothed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/rings/simplify.h"
#include "common/geometry/vector.h"

namespace slicefarm::infill {
namespace {

constexpr double kStepsPerLength = 2;
/// Distance, in steps, beyond which the Green's function is below 1e-5 of its peak.
constexpr int kKernelReach = 28;
constexpr int kPeriod = 256;  ///< period of the lattice on which the kernel is computed
constexpr Coord kSmoothToleranceNm = 5'000;

using Kernel = std::array<double, kKernelReach + 1>;

/// Returns the Green's function of 1 - l^2 D2 + l^4 D4 on points l / 2 apart, by its Fourier
/// series.
Kernel GreensFunction() {
  constexpr double kLength = kStepsPerLength;  // length in steps
  Kernel kernel{};
  for (int wave = 0; wave < kPeriod; ++wave) {
    const double turn = 2 * std::numbers::pi * wave / kPeriod;
    const double d2 = 2 - 2 * Cos(turn);
    const double share =
        1 / (1 + kLength * kLength * d2 + kLength * kLength * kLength * kLength * d2 * d2);
    for (int step = 0; step <= kKernelReach; ++step)
      kernel[static_cast<size_t>(step)] += share * Cos(turn * step) / kPeriod;
  }
  double sum = kernel[0];
  for (int step = 1; step <= kKernelReach; ++step) sum += 2 * kernel[static_cast<size_t>(step)];
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

/// Returns points at `count` even steps along a line, beginning with its first point.
std::vector<Vector2> EvenPoints(const Polyline& line, double length, int64_t count) {
  std::vector<Vector2> points;
  size_t i = 1;
  double passed = 0, edge = Distance(line[0], line[1]);
  for (int64_t k = 0; k < count; ++k) {
    const double at = length * static_cast<double>(k) / static_cast<double>(count);
    while (i + 1 < line.size() && passed + edge < at) {
      passed += edge;
      ++i;
      edge = Distance(line[i - 1], line[i]);
    }
    const double share = edge > 0 ? std::min(1.0, (at - passed) / edge) : 0;
    const Point a = line[i - 1], path = line[i] - line[i - 1];
    points.push_back(ToVector(a) + share * ToVector(path));
  }
  return points;
}

/// Returns a point of a curve. An open curve is continued beyond its ends by its own points,
/// rotated by 180 degrees around the end.
Vector2 PointAt(const std::vector<Vector2>& points, int64_t i, bool closed) {
  const auto count = static_cast<int64_t>(points.size());
  if (closed) return points[static_cast<size_t>((i % count + count) % count)];
  const int64_t last = count - 1;
  const auto turned = [&](int64_t about, int64_t from) {
    const Vector2 o = points[static_cast<size_t>(about)];
    const Vector2 p = points[static_cast<size_t>(std::clamp<int64_t>(from, 0, last))];
    return Vector2(2 * o - p);
  };
  if (i < 0) return turned(0, -i);
  if (i > last) return turned(last, 2 * last - i);
  return points[static_cast<size_t>(i)];
}

}  // namespace

Curve Smoothed(const Curve& curve, double length_nm) {
  static const Kernel kKernel = GreensFunction();
  Polyline line = curve.points;
  if (curve.closed) line.push_back(line.front());
  const double length = Length(line);
  if (length_nm <= 0 || length < 4 * length_nm) return curve;
  const auto steps = std::llround(kStepsPerLength * length / length_nm);
  std::vector<Vector2> points = EvenPoints(line, length, steps);
  if (!curve.closed) points.push_back(ToVector(line.back()));
  Polyline smooth;
  for (int64_t i = 0; i < static_cast<int64_t>(points.size()); ++i) {
    const Vector2 own = PointAt(points, i, curve.closed);
    Vector2 sum = kKernel[0] * own;
    for (int64_t step = 1; step <= kKernelReach; ++step) {
      const Vector2 before = PointAt(points, i - step, curve.closed);
      const Vector2 after = PointAt(points, i + step, curve.closed);
      sum += kKernel[static_cast<size_t>(step)] * (before + after);
    }
    const Point p = RoundedPoint(sum);
    if (smooth.empty() || smooth.back() != p) smooth.push_back(p);
  }
  if (!curve.closed) return {SimplifyLine(smooth, kSmoothToleranceNm), false};
  Polygon ring = SimplifyRing(smooth, kSmoothToleranceNm);
  return ring.empty() ? curve : Curve{std::move(ring), true};
}

}  // namespace slicefarm::infill
