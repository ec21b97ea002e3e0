#include "common/geometry/skeleton/bisector.h"

#include <cmath>
#include <utility>

namespace slicefarm {
namespace {

/// Distance in nm between two features below which their curve is not stable.
constexpr double kLeastDistanceNm = 1;

/// Returns the real roots of a t^2 + 2 b t + c. A double root is returned once.
Roots RootsOf(double a, double b, double c) {
  const double square = b * b - a * c;
  // The sum has no cancellation, and the quotients remain finite if `a` vanishes.
  const double q = -(b + std::copysign(std::sqrt(std::max(square, 0.0)), b));
  // A negative square is a double root if it is within the rounding error of its terms.
  if (square < -1e-12 * b * b) return {};
  Roots roots;
  if (q == 0) {
    if (a != 0) roots.t[roots.count++] = 0;
    return roots;
  }
  const double near = c / q, far = q / a;
  if (std::isfinite(near)) roots.t[roots.count++] = near;
  if (std::isfinite(far) && far != near) roots.t[roots.count++] = far;
  if (roots.count == 2 && roots.t[0] > roots.t[1]) std::swap(roots.t[0], roots.t[1]);
  return roots;
}

}  // namespace

std::optional<Bisector> Bisector::OfLines(const SidedLine& left, const SidedLine& right) {
  // With the normals n, the direction of both distances' equal growth is n_right - n_left, turned
  // to the right.
  const Vector2 between = right.normal - left.normal;
  const double size = Norm(between);
  if (!(size > 1e-9)) return std::nullopt;
  Bisector curve;
  curve.c1_ = -TurnedLeft(between) / size;
  // The point of the curve nearest to the origin in the direction of `between`.
  curve.c0_ = between * ((left.offset - right.offset) / (size * size));
  curve.r0_ = left.DistanceTo(curve.c0_);
  curve.r1_ = Dot(left.normal, curve.c1_);
  curve.has_directrix_ = true;
  curve.directrix_ = left;
  return curve;
}

std::optional<Bisector> Bisector::OfPoints(const Vector2& left, const Vector2& right) {
  const Vector2 between = left - right;
  const double distance = Norm(between);
  if (!(distance > kLeastDistanceNm)) return std::nullopt;
  Bisector curve;
  curve.c0_ = (left + right) / 2;
  curve.c1_ = -TurnedLeft(between) / distance;
  curve.r0_ = distance / 2;
  curve.has_focus_ = true;
  curve.focus_ = left;
  return curve;
}

std::optional<Bisector> Bisector::OfLineAndPoint(const SidedLine& left, const Vector2& right) {
  return OfFocus(left, right, TurnedLeft(left.normal));
}

std::optional<Bisector> Bisector::OfPointAndLine(const Vector2& left, const SidedLine& right) {
  return OfFocus(right, left, -TurnedLeft(right.normal));
}

std::optional<Bisector> Bisector::OfFocus(const SidedLine& line, const Vector2& point,
                                          const Vector2& along) {
  const double height = line.DistanceTo(point);
  if (!(height > kLeastDistanceNm)) return std::nullopt;
  Bisector curve;
  curve.c0_ = point - line.normal * (height / 2);
  curve.c1_ = along;
  curve.c2_ = line.normal / (2 * height);
  curve.r0_ = height / 2;
  curve.r2_ = 1 / (2 * height);
  curve.has_focus_ = curve.has_directrix_ = true;
  curve.focus_ = point;
  curve.directrix_ = line;
  return curve;
}

Disc Bisector::At(double t) const {
  return {c0_ + t * c1_ + (t * t) * c2_,
          has_directrix_ ? r0_ + t * (r1_ + t * r2_) : std::sqrt(r0_ * r0_ + t * t)};
}

Roots Bisector::Touching(const SidedLine& line) const {
  if (has_directrix_) {
    // The radius is the distance from the directrix.
    return Crossing({line.normal - directrix_.normal, line.offset - directrix_.offset});
  }
  // (distance of the centre)^2 = radius^2; the side is tested afterwards.
  const double m = line.DistanceTo(c0_), g = Dot(line.normal, c1_);
  Roots touching;
  for (const double t : RootsOf(g * g - 1, m * g, m * m - r0_ * r0_))
    if (m + t * g >= 0) touching.t[touching.count++] = t;
  return touching;
}

Roots Bisector::Touching(const Vector2& point) const {
  if (has_focus_) {
    // The radius is the distance from the focus.
    return Crossing({2 * (focus_ - point), Dot(point - focus_, point + focus_)});
  }
  const Vector2 from = c0_ - point;
  return RootsOf(1 - r1_ * r1_, Dot(from, c1_) - r0_ * r1_, Dot(from, from) - r0_ * r0_);
}

Roots Bisector::Crossing(const SidedLine& line) const {
  const double constant = line.DistanceTo(c0_), slope = Dot(line.normal, c1_);
  const double bend = Dot(line.normal, c2_);
  if (bend != 0) return RootsOf(bend, slope / 2, constant);
  const double t = -constant / slope;
  if (!std::isfinite(t)) return {};
  return {{t, 0}, 1};
}

}  // namespace slicefarm
