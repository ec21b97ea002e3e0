#pragma once

#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::motion {

/// Arc as given by G2 and G3.
struct Arc {
  Vector2 from = Vector2::Zero();
  Vector2 to = Vector2::Zero();
  Vector2 centre = Vector2::Zero();
  bool clockwise = false;

  /// Returns the distance of the arc's start from its centre. StartRadius and EndRadius are equal
  /// except for rounding.
  double StartRadius() const;
  /// Returns the distance of the arc's end from its centre.
  double EndRadius() const;
  /// Returns the swept angle in radians, above 0 for both directions. A full circle if both ends
  /// are equal.
  double Angle() const;
};

/// Returns the centre of the arc of radius |r|: the shorter arc if r > 0, the longer one otherwise.
/// If the ends are farther apart than twice the radius, returns the midpoint between the ends.
/// REQUIRES: from != to.
Vector2 CentreByRadius(Vector2 from, Vector2 to, double radius, bool clockwise);

/// Returns the end points of the chords by which firmwares replace the arc. The number of chords is
/// length_mm / segment_mm, rounded down, but at least one. The last chord ends at `arc.to`.
/// `length_mm`: length of the arc including its rise.
std::vector<Vector2> ArcChords(const Arc& arc, double length_mm, double segment_mm);

}  // namespace slicefarm::motion
