#pragma once

#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// A place where a ring turns.
struct Corner {
  double along_nm = 0;  ///< from the ring's first point
  double turn_rad = 0;  ///< > 0: the solid's corner sticks out
};

/// A place on a ring, and how the ring runs there: the arms are half a millimetre long if nothing else
/// is said, so that fine facets do not hide a corner; shorter on small rings.
struct Bend {
  Point at;
  Point in;   ///< the arm from the point before it
  Point out;  ///< the arm to the point after it

  /// In [-pi, pi]; > 0 where the solid sticks out.
  double TurnRad() const;

  /// Away from the solid: the outward direction, as a sixteenth of the full turn in [0, kOutwards).
  int Outward() const;
};

/// How many directions Bend::Outward tells apart.
inline constexpr int kOutwards = 16;

/// The middle of such a direction.
double OutwardAngleRad(int outward);

/// A ring by the length along it.
class RingShape {
 public:
  static constexpr double kArmNm = 0.5 * kNmPerMm;

  /// `ring` must outlive this. REQUIRES: a length, and below 10^9 points.
  explicit RingShape(const Polygon& ring, double arm_nm = kArmNm);

  double length_nm() const { return length_nm_; }

  /// Of a Bend's arms.
  double arm_nm() const { return arm_nm_; }

  /// How far along the ring its point `i` lies.
  double AlongTo(size_t i) const { return ends_[i]; }

  /// The places so far along. REQUIRES: ascending, within [0, length). Cost: O(points + places).
  std::vector<Bend> BendsAt(std::span<const double> along_nm) const;

  /// Where the ring turns most, by ascending length; of a rounded corner its middle. None on a ring
  /// that turns alike everywhere. Cost: O(points).
  std::vector<Corner> Corners() const;

 private:
  /// Any along_nm within a length of the ring's ends. `edge` is where the search begins, and then
  /// where it ended: who goes round the ring looks at each edge once.
  Point At(double along_nm, size_t& edge) const;
  /// The points where the ring turns, from a straight place on: beyond the ring's end, more than a
  /// length along.
  std::vector<Corner> Turns() const;

  const Polygon* ring_;
  std::vector<double> ends_;  ///< of each point, and of the whole
  double length_nm_ = 0;
  double arm_nm_ = 0;
};

}  // namespace slicefarm::planning
