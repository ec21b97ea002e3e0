#pragma once

#include <array>
#include <optional>

#include "common/geometry/vector.h"

namespace slicefarm {

/// A line with a side from which distances are counted: normal . p + offset, with a normal of
/// length 1.
struct SidedLine {
  Vector2 normal;
  double offset = 0;

  double DistanceTo(const Vector2& p) const { return Dot(normal, p) + offset; }
};

/// A circle by its centre and radius.
struct Disc {
  Vector2 centre;
  double radius = 0;
};

/// At most two parameters of a curve, ascending.
struct Roots {
  std::array<double, 2> t = {};
  int count = 0;

  const double* begin() const { return t.data(); }
  const double* end() const { return t.data() + count; }
};

/// The curve of the points that have equal distances to two features: a line for two lines or two
/// points, a parabola for a line and a point. Its parameter t grows in the direction in which the
/// first feature is on the left and the second on the right. Source: elementary; all equations are
/// linear or quadratic in t.
class Bisector {
 public:
  /// Returns nothing if the features are too close to each other for a stable curve.
  static std::optional<Bisector> OfLines(const SidedLine& left, const SidedLine& right);
  static std::optional<Bisector> OfPoints(const Vector2& left, const Vector2& right);
  static std::optional<Bisector> OfLineAndPoint(const SidedLine& left, const Vector2& right);
  static std::optional<Bisector> OfPointAndLine(const Vector2& left, const SidedLine& right);

  /// Returns the disc that touches both features.
  Disc At(double t) const;
  /// Returns the parameter of a point of the curve.
  double ParameterOf(const Vector2& p) const { return Dot(p - c0_, c1_); }

  /// Returns the parameters at which the disc touches the line, on the positive side of the line.
  Roots Touching(const SidedLine& line) const;
  /// Returns the parameters at which the disc's edge passes the point.
  Roots Touching(const Vector2& point) const;
  /// Returns the parameters at which the centre is on a line: normal . centre + offset = 0.
  Roots Crossing(const SidedLine& line) const;

 private:
  static std::optional<Bisector> OfFocus(const SidedLine& line, const Vector2& point,
                                         const Vector2& along);

  // The centre is c0 + c1 t + c2 t^2. The radius is r0 + r1 t + r2 t^2, or between two points
  // sqrt(r0^2 + t^2).
  Vector2 c0_, c1_, c2_ = Vector2::Zero();
  double r0_ = 0, r1_ = 0, r2_ = 0;
  bool has_focus_ = false;      ///< true if one feature is a point
  bool has_directrix_ = false;  ///< true if one feature is a line
  Vector2 focus_ = Vector2::Zero();
  SidedLine directrix_ = {Vector2::Zero(), 0};
};

}  // namespace slicefarm
