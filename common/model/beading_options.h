#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

struct BeadingOptions {
  int32_t perimeters = 3;                ///< perimeters
  Coord external_width_nm = 450'000;     ///< external_perimeter_extrusion_width
  Coord inner_width_nm = 450'000;        ///< perimeter_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< first_layer_extrusion_width, for all walls of layer 0
  bool gap_fill = true;                  ///< gap_fill_enabled
  Coord min_gap_width_nm = 80'000;       ///< gap_fill_min_width: narrower gaps stay empty
  Coord max_gap_width_nm = 800'000;      ///< wider gaps are the infill's

  friend bool operator==(const BeadingOptions&, const BeadingOptions&) = default;
};

}  // namespace slicefarm
