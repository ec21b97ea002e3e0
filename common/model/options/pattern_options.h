#pragma once

#include <cstdint>
#include <numbers>

#include "common/geometry/point.h"

namespace slicefarm {

/// Options of single infill patterns. Member comments begin with the name of the setting.
struct PatternOptions {
  int32_t lines = 1;                             ///< `fill_multiline`: number of lines side by side
  double lattice_1_rad = -std::numbers::pi / 4;  ///< setting lateral_lattice_angle_1
  double lattice_2_rad = std::numbers::pi / 4;   ///< setting lateral_lattice_angle_2
  double honeycomb_rad = std::numbers::pi / 3;   ///< setting infill_overhang_angle
  Coord shift_nm = 400'000;                      ///< setting infill_shift_step
  bool mirrored = false;                         ///< setting symmetric_infill_y_axis

  friend bool operator==(const PatternOptions&, const PatternOptions&) = default;
};

/// Options of the pattern lockedzag: a skin along the walls, and a skeleton inside it that reaches
/// into the skin. Member comments begin with the name of the setting.
struct LockedZagOptions {
  double skin_density = 0.25;         ///< setting skin_infill_density
  double skeleton_density = 0.25;     ///< setting skeleton_infill_density
  Coord skin_width_nm = 450'000;      ///< setting skin_infill_line_width
  Coord skeleton_width_nm = 450'000;  ///< setting skeleton_infill_line_width
  Coord skin_depth_nm = 2'000'000;    ///< setting skin_infill_depth
  Coord lock_depth_nm = 1'000'000;    ///< setting infill_lock_depth

  friend bool operator==(const LockedZagOptions&, const LockedZagOptions&) = default;
};

}  // namespace slicefarm
