#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

struct GrownCutter;

/// A part of a cutter's outline, between two heights above the tip: an arc or a straight line.
struct ProfilePiece {
  double from_mm = 0;
  double to_mm = std::numeric_limits<double>::infinity();
  double corner_mm = 0;  ///< of an arc: its radius, its centre as high above the tip; 0: a line
  double flat_mm = 0;    ///< of an arc: its centre's distance from the axis
  double base_mm = 0;    ///< of a line: its radius, drawn on to the height of the tip
  double slope = 0;      ///< of a line: growth of the radius by height; >= 0

  friend bool operator==(const ProfilePiece&, const ProfilePiece&) = default;
};

/// A cutter that turns about a vertical axis: its radius by the height above its tip. The radius
/// never falls, and grows slower the higher up: the cutter is convex. Its shaft goes up without
/// end.
///
/// Angles are half angles at a cone's tip, in degrees. Errors of all makers: SETTING_OUT_OF_RANGE
/// for what is not above zero or not finite, for a corner above the radius, for an angle of 90
/// degrees or more, and for composites whose parts do not form a convex outline.
class Cutter {
 public:
  Cutter() : Cutter(*Ball(4)) {}  ///< the usual one

  static absl::StatusOr<Cutter> Cylinder(double diameter_mm);
  static absl::StatusOr<Cutter> Ball(double diameter_mm);
  static absl::StatusOr<Cutter> Bull(double diameter_mm, double corner_mm);
  static absl::StatusOr<Cutter> Cone(double diameter_mm, double angle_deg);
  /// A ball of `tip_mm` in diameter that goes on, tangentially, as a cone up to `diameter_mm`.
  static absl::StatusOr<Cutter> BallCone(double tip_mm, double angle_deg, double diameter_mm);
  /// The same with a bull nose.
  static absl::StatusOr<Cutter> BullCone(double tip_mm, double corner_mm, double angle_deg,
                                         double diameter_mm);
  /// A cone up to `tip_mm` in diameter, a steeper one above. REQUIRES angle_deg < tip_angle_deg.
  static absl::StatusOr<Cutter> ConeCone(double tip_mm, double tip_angle_deg, double angle_deg,
                                         double diameter_mm);

  /// As ParseCutter reads it, in canonical form; of a grown cutter: empty.
  const std::string& name() const { return name_; }
  double radius_mm() const { return radius_mm_; }
  /// From here up the cutter is a cylinder.
  double full_height_mm() const { return pieces_.back().from_mm; }
  /// From the tip up; the last one is the shaft, a line without slope or end.
  const std::vector<ProfilePiece>& pieces() const { return pieces_; }

  /// The radius at a height. REQUIRES: height_mm >= 0.
  double Width(double height_mm) const;
  /// The height at which a plane touches that rises by `rise` over a horizontal way of `run`: where
  /// Width grows by run / rise. REQUIRES: both >= 0, run > 0 if the cutter has an arc.
  double TouchHeight(double rise, double run) const;
  /// The least height at which the cutter is as wide. REQUIRES: 0 <= distance_mm <= radius_mm().
  double HeightAt(double distance_mm) const;

  /// All within `by_mm` of the cutter; below 0: what is left of it farther inside than that. A kink
  /// between two straight lines is mitred, not rounded: there it is a little more than that.
  /// REQUIRES: -radius_mm() < by_mm.
  GrownCutter Grown(double by_mm) const;

  friend bool operator==(const Cutter&, const Cutter&) = default;

 private:
  Cutter(std::string name, std::vector<ProfilePiece> pieces, double radius_mm)
      : name_(std::move(name)), pieces_(std::move(pieces)), radius_mm_(radius_mm) {}

  std::string name_;
  std::vector<ProfilePiece> pieces_;
  double radius_mm_;
};

/// A cutter that stands for another one with a layer around it.
struct GrownCutter {
  Cutter cutter;
  double tip_mm = 0;  ///< height of its tip above the other one's: below 0 if it is larger
};

}  // namespace slicefarm
