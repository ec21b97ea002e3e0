#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/point.h"
#include "common/model/fill_patterns.h"

namespace slicefarm {

struct InfillOptions {
  int32_t top_solid_layers = 5;                            ///< top_solid_layers
  int32_t bottom_solid_layers = 5;                         ///< bottom_solid_layers
  double density = 0.2;                                    ///< fill_density, [0, 1]
  FillPattern pattern = FillPattern::kGrid;                ///< fill_pattern
  FillPattern solid_pattern = FillPattern::kMonotonic;     ///< inside: solid_fill_pattern
  FillPattern top_pattern = FillPattern::kMonotonic;       ///< top_fill_pattern
  FillPattern bottom_pattern = FillPattern::kMonotonic;    ///< bottom_fill_pattern
  double angle_rad =
      0.78539816339744831;  ///< fill_angle; solid layers turn by a right angle from layer to layer
  Coord sparse_width_nm = 450'000;       ///< infill_extrusion_width
  Coord solid_width_nm = 450'000;        ///< solid_infill_extrusion_width
  Coord top_width_nm = 450'000;          ///< top_infill_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< first_layer_extrusion_width
  Coord overlap_nm = 157'500;  ///< infill_overlap: how far the lines' ends reach into the walls
  double solid_below_area_mm2 =
      0;  ///< solid_infill_below_area: smaller sparse regions become solid
  Coord anchor_nm = 2'700'000;       ///< infill_anchor: of a line's end that is not linked
  Coord anchor_max_nm = 50'000'000;  ///< infill_anchor_max: longest link; 0: none
  int32_t solid_every_layers = 0;    ///< solid_infill_every_layers; 0: none
  double bridge_angle_rad = 0;       ///< bridge_angle; 0: found for each bridge
  /// density_field, stress_field: canonical texts (fields/field_text.h); empty: none.
  std::string density_field;
  std::string stress_field;
  /// How many layers above and below density_field looks at for the distance to the surface.
  int32_t field_halo_layers = 0;

  friend bool operator==(const InfillOptions&, const InfillOptions&) = default;
};

}  // namespace slicefarm
