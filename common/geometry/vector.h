#pragma once

#include <Eigen/Core>

namespace slicefarm {

/// A place or a way in the plane in doubles, of whatever unit. Not set unless it is said.
using Vector2 = Eigen::Vector2d;

inline double Dot(const Vector2& a, const Vector2& b) { return a.x() * b.x() + a.y() * b.y(); }
inline double Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// A quarter turn to the left.
inline Vector2 TurnedLeft(const Vector2& a) { return {-a.y(), a.x()}; }

}  // namespace slicefarm
