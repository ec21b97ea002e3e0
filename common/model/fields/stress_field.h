#pragma once

#include <cstdint>

#include "common/model/fields/field_grid.h"

namespace slicefarm {

/// Stresses of a part in the plane of its layers, in any unit. All three grids have the same nodes.
struct StressField {
  FieldGrid xx;
  FieldGrid yy;
  FieldGrid xy;
  int32_t smoothing = 1;  ///< number of smoothing passes over the field of directions, 0 to 100

  friend bool operator==(const StressField&, const StressField&) = default;
};

}  // namespace slicefarm
