#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

struct GrownCutter;

/// Piece of a cutter's profile between the heights from_mm and to_mm above the tip: an arc or a
/// straight line.
struct ProfilePiece {
  double from_mm = 0;
  double to_mm = std::numeric_limits<double>::infinity();
  /// arc: radius, and at the same time the height of the arc's centre; 0: the piece is a line
  double corner_mm = 0;
  double flat_mm = 0;  ///< arc: distance of the arc's centre from the axis
  double base_mm = 0;  ///< line: radius at height 0, to which the line is extended
  double slope = 0;    ///< line: increase of the radius per height; >= 0

  friend bool operator==(const ProfilePiece&, const ProfilePiece&) = default;
};

/// Cutter that turns about a vertical axis, described by its radius at each height above the tip.
/// The cutter is convex: the radius never decreases with height, and its slope never increases. The
/// shaft has no upper end.
///
/// Angles are half angles at the tip of a cone, in degrees. The functions that make a cutter return
/// SETTING_OUT_OF_RANGE for sizes that are not positive or not finite. They also return this error
/// for a corner radius above the cutter's radius, an angle of 90 degrees or more, and sizes without
/// a convex profile.
class Cutter {
 public:
  Cutter() : Cutter(*Ball(4)) {}  ///< Makes the default cutter, a ball of 4 mm.

  static absl::StatusOr<Cutter> Cylinder(double diameter_mm);
  static absl::StatusOr<Cutter> Ball(double diameter_mm);
  static absl::StatusOr<Cutter> Bull(double diameter_mm, double corner_mm);
  static absl::StatusOr<Cutter> Cone(double diameter_mm, double angle_deg);
  /// Makes a ball of diameter `tip_mm` with a tangential cone up to `diameter_mm`.
  static absl::StatusOr<Cutter> BallCone(double tip_mm, double angle_deg, double diameter_mm);
  /// Makes a bull nose of diameter `tip_mm` with a tangential cone up to `diameter_mm`.
  static absl::StatusOr<Cutter> BullCone(double tip_mm, double corner_mm, double angle_deg,
                                         double diameter_mm);
  /// Makes a cone up to diameter `tip_mm` with a steeper cone above. REQUIRES: angle_deg <
  /// tip_angle_deg.
  static absl::StatusOr<Cutter> ConeCone(double tip_mm, double tip_angle_deg, double angle_deg,
                                         double diameter_mm);

  /// Returns the cutter's text in the canonical form of ParseCutter. Returns an empty text for the
  /// result of Grown.
  const std::string& name() const { return name_; }
  double radius_mm() const { return radius_mm_; }
  /// Returns the height from which the cutter is a cylinder.
  double full_height_mm() const { return pieces_.back().from_mm; }
  /// Returns the pieces from the tip upwards. The last piece is the shaft, a line with slope 0 and
  /// no end.
  const std::vector<ProfilePiece>& pieces() const { return pieces_; }

  /// Returns the radius at a height. REQUIRES: height_mm >= 0.
  double Width(double height_mm) const;
  /// Returns the height above the tip at which an inclined plane touches the cutter. The plane
  /// rises by `rise` over the horizontal distance `run`; at this height Width has the slope run /
  /// rise. REQUIRES: both >= 0, run > 0 if the cutter has an arc.
  double TouchHeight(double rise, double run) const;
  /// Returns the smallest height at which the radius is `distance_mm`. REQUIRES: 0 <= distance_mm
  /// <= radius_mm().
  double HeightAt(double distance_mm) const;

  /// Returns the cutter offset by `by_mm`: outwards, or inwards if `by_mm` is negative. A kink
  /// between two straight lines is mitred instead of rounded, so the result is slightly larger at a
  /// kink. REQUIRES: -radius_mm() < by_mm.
  GrownCutter Grown(double by_mm) const;

  friend bool operator==(const Cutter&, const Cutter&) = default;

 private:
  Cutter(std::string name, std::vector<ProfilePiece> pieces, double radius_mm)
      : name_(std::move(name)), pieces_(std::move(pieces)), radius_mm_(radius_mm) {}

  std::string name_;
  std::vector<ProfilePiece> pieces_;
  double radius_mm_;
};

/// Result of Cutter::Grown.
struct GrownCutter {
  Cutter cutter;
  /// Height of this cutter's tip above the original tip; negative if this cutter is larger.
  double tip_mm = 0;
};

}  // namespace slicefarm
