#pragma once

#include <cstdint>
#include <numbers>

#include "common/geometry/point.h"

namespace slicefarm {

/// Limits of PatternOptions::gyroid_waves. The pattern keeps its density between them.
inline constexpr double kLeastGyroidWaves = 0.5, kMostGyroidWaves = 2;

/// Options of single infill patterns. Member comments begin with the name of the setting.
struct PatternOptions {
  int32_t lines = 1;                             ///< `fill_multiline`: number of lines side by side
  double lattice_1_rad = -std::numbers::pi / 4;  ///< setting lateral_lattice_angle_1
  double lattice_2_rad = std::numbers::pi / 4;   ///< setting lateral_lattice_angle_2
  double honeycomb_rad = std::numbers::pi / 3;   ///< setting infill_overhang_angle
  Coord shift_nm = 400'000;                      ///< setting infill_shift_step
  bool separated = false;                        ///< setting separated_infills
  bool mirrored = false;                         ///< setting symmetric_infill_y_axis
  double smooth = 0;  ///< `sparse_infill_smooth_factor`: share of an edge that round corners take
  bool stiff_gyroid = false;  ///< setting gyroid_optimized
  /// waves of the gyroid per period along the lines, if stiff_gyroid; computed from the density
  double gyroid_waves = 1;
  double lightning_overhang_rad = std::numbers::pi / 4;    ///< setting lightning_overhang_angle
  double lightning_prune_rad = std::numbers::pi / 4;       ///< setting lightning_prune_angle
  double lightning_straighten_rad = std::numbers::pi / 4;  ///< `lightning_straightening_angle`

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
