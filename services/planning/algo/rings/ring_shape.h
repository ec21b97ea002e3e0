#pragma once

#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Corner of a ring.
struct Corner {
  double along_nm = 0;  ///< length from the ring's first point
  double turn_rad = 0;  ///< turn; > 0 at a convex corner of the solid
};

/// Place on a ring and the ring's direction around it. The arms are half a millimetre long by
/// default, so that fine facets do not hide a corner. On small rings they are shorter.
struct Bend {
  Point at;
  Point in;   ///< arm from the point before it
  Point out;  ///< arm to the point after it

  /// Returns the turn in [-pi, pi]; > 0 where the solid is convex.
  double TurnRad() const;

  /// Returns the direction away from the solid, as a sixteenth of the full turn in [0, kOutwards).
  int Outward() const;
};

/// Number of directions that Bend::Outward distinguishes.
inline constexpr int kOutwards = 16;

/// Returns the middle angle of such a direction.
double OutwardAngleRad(int outward);

/// Ring with positions given by the length along it.
class RingShape {
 public:
  static constexpr double kArmNm = 0.5 * kNmPerMm;

  /// `ring` must outlive this object. REQUIRES: the ring has a length, and fewer than 10^9 points.
  explicit RingShape(const Polygon& ring, double arm_nm = kArmNm);

  double length_nm() const { return length_nm_; }

  /// Returns the length of a Bend's arms.
  double arm_nm() const { return arm_nm_; }

  /// Returns the length along the ring to its point `i`.
  double AlongTo(size_t i) const { return ends_[i]; }

  /// Returns the bends at the given lengths. REQUIRES: ascending, within [0, length). Cost:
  /// O(points + places).
  std::vector<Bend> BendsAt(std::span<const double> along_nm) const;

  /// Returns the corners in the order of their position; for a rounded corner, its middle. A ring
  /// with the same turn everywhere has no corners. Cost: O(points).
  std::vector<Corner> Corners() const;

 private:
  /// Returns the point at `along_nm`, which may be up to one length outside the ring's range. The
  /// search begins at `edge` and writes the found edge back. So a walk along the ring visits each
  /// edge once.
  Point At(double along_nm, size_t& edge) const;
  /// Returns the points where the ring turns, beginning after a straight place. Points past the
  /// ring's end have positions beyond the length.
  std::vector<Corner> Turns() const;

  const Polygon* ring_;
  std::vector<double> ends_;  ///< length at each point, and the total length at the end
  double length_nm_ = 0;
  double arm_nm_ = 0;
};

}  // namespace slicefarm::planning
