#pragma once

#include <Eigen/Core>
#include <cmath>

#include "common/geometry/point.h"

namespace slicefarm {

/// A position or a direction in the plane (Vector2) or in space (Vector3), in doubles of any unit.
/// Not initialised by default.
using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;

/// Converts a point to a vector of doubles.
inline Vector2 ToVector(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
/// Returns the vector as a point, rounded to nm.
inline Point RoundedPoint(const Vector2& v) { return {std::llround(v.x()), std::llround(v.y())}; }

inline double Dot(const Vector2& a, const Vector2& b) { return a.x() * b.x() + a.y() * b.y(); }
inline double Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }
inline double Norm(const Vector2& a) { return std::sqrt(Dot(a, a)); }
/// Returns the vector rotated by 90 degrees to the left.
inline Vector2 TurnedLeft(const Vector2& a) { return {-a.y(), a.x()}; }

}  // namespace slicefarm
