#include "common/geometry/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "common/base/portable_math.h"
#include "common/geometry/vector.h"

namespace slicefarm {
namespace {

constexpr size_t kFewestSegments = 3;
/// Part of the tolerance that is reserved for the rounding of the centre.
constexpr double kRoundingUm = 1.5;
constexpr double kLengthShare = 0.001;
/// Largest radius of an arc. Straighter curves gain nothing, and their centres are too far away.
constexpr double kGreatestRadiusUm = 1e6;
constexpr double kLeastRadiusUm = 100;
/// Largest turn of an arc. If the ends are too close to each other, the direction of the arc is
/// ambiguous.
constexpr double kMostTurn = 1.9 * std::numbers::pi;

Vector2 FromTo(PointUm from, PointUm to) {
  return {static_cast<double>(to.x) - from.x, static_cast<double>(to.y) - from.y};
}

double Length(const Vector2& a) { return Hypot(a.x(), a.y()); }

/// Returns the centre of the circle through three points; nothing if they are nearly on a line.
std::optional<PointUm> CentreThrough(PointUm a, PointUm b, PointUm c) {
  const Vector2 u = FromTo(a, b), v = FromTo(a, c);
  const double twice = 2 * Cross(u, v);
  if (twice == 0) return std::nullopt;
  const double uu = Dot(u, u), vv = Dot(v, v);
  const double x = (v.y() * uu - u.y() * vv) / twice, y = (u.x() * vv - v.x() * uu) / twice;
  if (!(Hypot(x, y) <= kGreatestRadiusUm)) return std::nullopt;
  return PointUm{a.x + static_cast<int32_t>(std::lround(x)),
                 a.y + static_cast<int32_t>(std::lround(y))};
}

/// Returns the arc for points[first] to points[last], if it fits.
std::optional<CurvePiece> ArcOf(std::span<const PointUm> points, size_t first, size_t last,
                                double tolerance_um) {
  const double reach_um = tolerance_um - kRoundingUm;
  const PointUm from = points[first], to = points[last];
  const auto centre = CentreThrough(from, points[(first + last) / 2], to);
  if (!centre) return std::nullopt;
  const double radius = Length(FromTo(*centre, from));
  if (radius < kLeastRadiusUm) return std::nullopt;
  if (std::abs(Length(FromTo(*centre, to)) - radius) > kRoundingUm) return std::nullopt;
  const bool clockwise = Cross(FromTo(*centre, from), FromTo(*centre, points[first + 1])) < 0;
  double turn = 0, length = 0;
  for (size_t i = first; i < last; ++i) {
    const Vector2 a = FromTo(*centre, points[i]), b = FromTo(*centre, points[i + 1]);
    const double cross = Cross(a, b);
    if (cross == 0 || (cross < 0) != clockwise) return std::nullopt;
    if (std::abs(Length(b) - radius) > reach_um) return std::nullopt;
    // The arc is farthest from a segment at the middle of the segment.
    if (std::abs(radius - Length((a + b) / 2)) > reach_um) return std::nullopt;
    turn += std::abs(Atan2(cross, Dot(a, b)));
    length += Length(FromTo(points[i], points[i + 1]));
  }
  if (turn > kMostTurn || std::abs(turn * radius - length) > kLengthShare * length)
    return std::nullopt;
  return CurvePiece{last, true, *centre, clockwise};
}

/// Returns the longest arc that starts at points[first]. The search doubles the number of segments
/// until an arc does not fit, then halves the step.
std::optional<CurvePiece> LongestArc(std::span<const PointUm> points, size_t first,
                                     double tolerance_um) {
  std::optional<CurvePiece> best;
  const size_t most = points.size() - 1 - first;
  size_t segments = 0, step = kFewestSegments;
  bool grows = true;
  while (step > 0) {
    const size_t next = segments + step;
    const auto arc = next <= most ? ArcOf(points, first, first + next, tolerance_um) : std::nullopt;
    if (arc) {
      best = arc;
      segments = next;
    } else if (segments == 0) {
      return std::nullopt;
    }
    grows = grows && arc.has_value();
    step = grows ? 2 * step : step / 2;
  }
  return best;
}

}  // namespace

std::vector<CurvePiece> FitArcs(std::span<const PointUm> points, double tolerance_um) {
  std::vector<CurvePiece> pieces;
  for (size_t at = 0; at + 1 < points.size();) {
    std::optional<CurvePiece> arc;
    if (at + kFewestSegments < points.size()) arc = LongestArc(points, at, tolerance_um);
    pieces.push_back(arc ? *arc : CurvePiece{at + 1, false, {}, false});
    at = pieces.back().last;
  }
  return pieces;
}

}  // namespace slicefarm
