#pragma once

#include <cstdint>
#include <optional>

#include "common/geometry/vector.h"
#include "common/model/fields/stress_field.h"

namespace slicefarm::infill {

/// The principal directions of a stress field in the plane of the layers: those of the stress that
/// is greater by magnitude, drawn or pressed; of two that are alike to kEqualPull, those of the
/// drawn one. The other family of directions is at right angles to them. Held as cos 2t and sin 2t,
/// which are the same for opposite directions, smoothed and interpolated as such.
///
/// A node where the stresses are alike in all directions, (sxx - syy)^2 + 4 sxy^2 below (kAlike
/// times the greatest of the field)^2, says nothing: it goes on as the nodes around it. Degenerate
/// are the places where directions around cancel each other: less than kLeastLength of them is
/// left. So are those along which pull and push change places as the greater, as both directions
/// turn by a right angle there.
class DirectionField {
 public:
  static constexpr double kAlike = 1e-3;
  static constexpr double kLeastLength = 0.15;
  static constexpr double kEqualPull = 0.01;

  explicit DirectionField(const StressField& stress);

  /// None: degenerate.
  std::optional<Vector2> At(const PlaceMm& place_mm) const;
  bool IsSameAtAllHeights() const { return cos2_.count[2] == 1; }

 private:
  FieldGrid cos2_;
  FieldGrid sin2_;
};

}  // namespace slicefarm::infill
