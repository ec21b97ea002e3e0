#pragma once

#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Corner of a ring.
struct Corner {
  double along_nm = 0;  ///< length along the ring from its first point
  double turn_rad = 0;  ///< change of direction; > 0 at a convex corner of the solid
};

/// Point on a ring, and the direction of the ring before and after the point. Directions are
/// measured over arms, which are half a millimetre long by default, so that fine facets do not hide
/// a corner. On small rings the arms are shorter.
struct Bend {
  Point at;
  Point in;   ///< vector from the start of the arm before the point to the point
  Point out;  ///< vector from the point to the end of the arm after it

  /// Returns the change of direction in [-pi, pi]; > 0 where the solid is convex.
  double TurnRad() const;

  /// Returns the direction away from the solid at this point, as an index in [0, kOutwards).
  int Outward() const;
};

/// Number of sectors of a full turn that Bend::Outward distinguishes.
inline constexpr int kOutwards = 16;

/// Returns the angle in radians of the middle of sector `outward` (Bend::Outward).
double OutwardAngleRad(int outward);

/// Ring as a curve: a position on it is the length along the ring from its first point, in nm.
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

  /// Returns the bends at the given lengths along the ring. REQUIRES: `along_nm` is in ascending
  /// order and within [0, length). Cost: O(points of the ring + bends).
  std::vector<Bend> BendsAt(std::span<const double> along_nm) const;

  /// Returns the corners, sorted by position. A rounded corner is returned once, at its middle. A
  /// ring that bends equally everywhere has no corners. Cost: O(points).
  std::vector<Corner> Corners() const;

 private:
  /// Returns the point at `along_nm`, which may be up to one length of the ring before its start or
  /// after its end. `edge`: index of the edge at which the search begins; set to the edge that is
  /// found. So a walk along the ring visits each edge once.
  Point At(double along_nm, size_t& edge) const;
  /// Returns the points at which the ring bends, in order along the ring, beginning after a
  /// straight section. Where this order passes the ring's first point, positions continue beyond
  /// the ring's length.
  std::vector<Corner> Turns() const;

  const Polygon* ring_;
  std::vector<double> ends_;  ///< length at each point, and the total length at the end
  double length_nm_ = 0;
  double arm_nm_ = 0;
};

}  // namespace slicefarm::planning
