#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

enum class SparsePattern { kRectilinear, kGrid };
enum class SolidPattern { kMonotonic, kRectilinear };

struct InfillOptions {
  int32_t top_solid_layers = 5;                            ///< top_solid_layers
  int32_t bottom_solid_layers = 5;                         ///< bottom_solid_layers
  double density = 0.2;                                    ///< fill_density, [0, 1]
  SparsePattern pattern = SparsePattern::kGrid;            ///< fill_pattern
  SolidPattern solid_pattern = SolidPattern::kMonotonic;   ///< inside: solid_fill_pattern
  SolidPattern top_pattern = SolidPattern::kMonotonic;     ///< top_fill_pattern
  SolidPattern bottom_pattern = SolidPattern::kMonotonic;  ///< bottom_fill_pattern
  double angle_rad =
      0.78539816339744831;  ///< fill_angle; solid layers turn by a right angle from layer to layer
  Coord sparse_width_nm = 450'000;       ///< infill_extrusion_width
  Coord solid_width_nm = 450'000;        ///< solid_infill_extrusion_width
  Coord top_width_nm = 450'000;          ///< top_infill_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< first_layer_extrusion_width
  Coord overlap_nm = 157'500;  ///< infill_overlap: how far the lines' ends reach into the walls
  double solid_below_area_mm2 =
      0;  ///< solid_infill_below_area: smaller sparse regions become solid

  friend bool operator==(const InfillOptions&, const InfillOptions&) = default;
};

}  // namespace slicefarm
