#pragma once

#include <vector>

#include "common/model/fields/density_field.h"

namespace slicefarm {

/// Share of each material in the plastic of a mixing extruder, as a function of the position on the
/// plate. INVARIANT: all parts have the same kind and nodes, and the sum of their values at each
/// node is 1.
struct MaterialField {
  /// One field per material, at least two. The value of a field is the material's share; its
  /// formula is DensityLaw::kLinear.
  std::vector<DensityField> parts;
  double step = 0.05;  ///< smallest change of a share that causes a new mix command

  friend bool operator==(const MaterialField&, const MaterialField&) = default;
};

}  // namespace slicefarm
