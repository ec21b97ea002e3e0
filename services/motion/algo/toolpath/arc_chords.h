#pragma once

#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::motion {

/// An arc as G2 and G3 give it.
struct Arc {
  Vector2 from = Vector2::Zero();
  Vector2 to = Vector2::Zero();
  Vector2 centre = Vector2::Zero();
  bool clockwise = false;

  /// Distances of the ends from the centre: equal, but for rounding.
  double StartRadius() const;
  double EndRadius() const;
  /// Angle swept, > 0; a full circle where the ends are the same.
  double Angle() const;
};

/// The centre of the arc of radius |r|, the shorter way round if r > 0, else the longer one. Where
/// the ends are farther apart than twice the radius, their middle. REQUIRES: from != to.
Vector2 CentreByRadius(Vector2 from, Vector2 to, double radius, bool clockwise);

/// Ends of the chords that stand for the arc in firmwares: as many as fit with `segment_mm` each,
/// at least one; the last ends at `arc.to`. `length_mm`: of the arc's way, with what it rises.
std::vector<Vector2> ArcChords(const Arc& arc, double length_mm, double segment_mm);

}  // namespace slicefarm::motion
