#pragma once

#include <array>
#include <cstdint>

#include "common/model/path.h"

namespace slicefarm {

/// Number of overhang degrees: 0, 25, 50 and 75 % of a wall's width rest on the layer below.
inline constexpr int kOverhangDegrees = 4;

/// Loops of a region that get a scarf.
enum class ScarfPlacement : uint8_t {
  kNowhere,
  kContours,  ///< the outer contours of islands
  kEverywhere,
};

/// A scarf: a loop begins low and thin, rises, and ends over its own beginning, in place of a butt
/// joint that shows.
struct ScarfOptions {
  ScarfPlacement placement = ScarfPlacement::kNowhere;  ///< scarf_seam_placement
  bool only_on_smooth = true;     ///< scarf_seam_only_on_smooth: not at corners
  bool on_inner = false;          ///< scarf_seam_on_inner_perimeters
  bool entire_loop = false;       ///< scarf_seam_entire_loop: the length is the loop's
  double start_height_ratio = 0;  ///< scarf_seam_start_height: where it begins in the layer
  double length_mm = 20;          ///< scarf_seam_length
  double max_segment_mm = 1;      ///< scarf_seam_max_segment_length: of steps of the flow

  friend bool operator==(const ScarfOptions&, const ScarfOptions&) = default;
};

/// Speeds, scarfs and bridges of one region.
struct RegionSpeeds {
  std::array<double, kFeatureCount> speed_mm_s = {30, 60, 30, 20, 80, 20, 15,
                                                  60, 60, 60, 60, 15, 0};  ///< by Feature
  double small_perimeter_speed_mm_s = 15;  ///< small_perimeter_speed: loops of radius below 6.5 mm
  bool dynamic_overhangs = false;          ///< enable_dynamic_overhang_speeds
  /// overhang_speed_0 to _3, by degree.
  std::array<double, kOverhangDegrees> overhang_speed_mm_s = {15, 15, 20, 25};
  ScarfOptions scarf;
  /// overhangs: walls over nothing are bridges, with their speed, fan and flow.
  bool bridging_walls = false;
  double bridge_flow = 1;     ///< bridge_flow_ratio
  bool thick_bridges = true;  ///< thick_bridges: round threads as wide as the nozzle

  friend bool operator==(const RegionSpeeds&, const RegionSpeeds&) = default;
};

}  // namespace slicefarm
