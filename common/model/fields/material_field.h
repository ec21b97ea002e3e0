#pragma once

#include <vector>

#include "common/model/fields/density_field.h"

namespace slicefarm {

/// What share of the extruded plastic each of the materials that a mixing extruder takes in has, by
/// place on the plate. INVARIANT: all parts have the same kind and nodes, and their sum at each is 1.
struct MaterialField {
  std::vector<DensityField> parts;  ///< of linear law; two or more
  double step = 0.05;               ///< a mix is set anew when a share changes by more

  friend bool operator==(const MaterialField&, const MaterialField&) = default;
};

}  // namespace slicefarm
