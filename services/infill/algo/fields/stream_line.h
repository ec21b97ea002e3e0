#pragma once

#include <cmath>
#include <deque>

namespace slicefarm::infill {

/// A place or a way in the plane, mm.
struct Vec2 {
  double x = 0, y = 0;

  Vec2 operator+(Vec2 o) const { return {x + o.x, y + o.y}; }
  Vec2 operator-(Vec2 o) const { return {x - o.x, y - o.y}; }
  Vec2 operator*(double f) const { return {x * f, y * f}; }
};

inline double Dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
inline double Cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double Length(Vec2 a) { return std::sqrt(Dot(a, a)); }

/// A line along a field of directions. A closed one goes on from its last point to its first.
struct StreamLine {
  std::deque<Vec2> points;  ///< it grows at both ends
  bool closed = false;
};

}  // namespace slicefarm::infill
