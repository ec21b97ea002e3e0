#pragma once

#include <cstdint>
#include <optional>

#include "common/geometry/vector.h"
#include "common/model/fields/stress_field.h"

namespace slicefarm::infill {

/// Principal directions of a stress field in the plane of the layers. The main direction is the
/// direction of the principal stress with the greater magnitude, tensile or compressive. If the two
/// magnitudes differ by less than kEqualPull times the difference of the two stresses, the tensile
/// stress gives the main direction. The second family of directions is perpendicular to the main
/// direction. The directions are stored, smoothed and interpolated as cos 2t and sin 2t (t: angle),
/// which are equal for opposite directions.
///
/// A node of the grid has no own direction if its stresses are nearly equal in all directions:
/// sqrt((sxx - syy)^2 + 4 sxy^2) is below kAlike times the field's greatest |sxx - syy| or |2 sxy|.
/// The node then gets the mean direction of its neighbours. A point is degenerate if the directions
/// around it cancel each other, so that the length of their mean is below kLeastLength. Points at
/// which tension and compression have equal magnitude are also degenerate, because the directions
/// turn by a right angle there.
class DirectionField {
 public:
  static constexpr double kAlike = 1e-3;
  static constexpr double kLeastLength = 0.15;
  static constexpr double kEqualPull = 0.01;

  /// Computes the directions of all nodes.
  explicit DirectionField(const StressField& stress);

  /// Returns the main direction at a point, as a unit vector; nullopt if the point is degenerate.
  /// The vector and its opposite mean the same direction.
  std::optional<Vector2> At(const PositionMm& position_mm) const;
  /// Returns true if the field does not depend on the height.
  bool IsSameAtAllHeights() const { return cos2_.count[2] == 1; }

 private:
  FieldGrid cos2_;
  FieldGrid sin2_;
};

}  // namespace slicefarm::infill
