#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// A place where a ring turns.
struct Corner {
  double along_nm = 0;  ///< from the ring's first point
  double turn_rad = 0;  ///< > 0: the solid's corner sticks out
};

/// A ring by the length along it.
class RingShape {
 public:
  /// `ring` must outlive this. REQUIRES: a length, and below 10^9 points.
  explicit RingShape(const Polygon& ring);

  double length_nm() const { return length_nm_; }

  /// How far along the ring its point `i` lies.
  double AlongTo(size_t i) const { return ends_[i]; }

  /// Any along_nm within a length of the ring's ends. Cost: O(log points).
  Point At(double along_nm) const;

  /// How much the ring turns over half a millimetre on either side, so that fine facets do not hide
  /// a corner; less on small rings. In [-pi, pi]; > 0 where the solid sticks out. Cost: O(log
  /// points).
  double TurnAt(double along_nm) const;

  /// Away from the solid: the outward direction of the ring at a place, as a sixteenth of the full
  /// turn in [0, 16).
  int OutwardAt(double along_nm) const;

  /// Where the ring turns most, by ascending length; of a rounded corner its middle. None on a ring
  /// that turns alike everywhere. Cost: O(points).
  std::vector<Corner> Corners() const;

 private:
  /// The two arms of a place: from the point before it, and to the point after it.
  struct Arms {
    Point in;
    Point out;
  };
  Arms ArmsAt(double along_nm) const;
  /// The points where the ring turns, from a straight place on: beyond the ring's end, more than a
  /// length along.
  std::vector<Corner> Turns() const;

  const Polygon* ring_;
  std::vector<double> ends_;  ///< of each point, and of the whole
  double length_nm_ = 0;
  double arm_nm_ = 0;
};

/// How many directions OutwardAt tells apart.
inline constexpr int kOutwards = 16;

/// The middle of such a direction.
double OutwardAngleRad(int outward);

}  // namespace slicefarm::planning
