#pragma once

#include <array>
#include <cstdint>

#include "common/geometry/point.h"
#include "common/model/path.h"

namespace slicefarm {

/// Number of overhang degrees. Walls of degree 0 to 3 have 0, 25, 50 and 75 % of their width on the
/// layer below.
inline constexpr int kOverhangDegrees = 4;

/// Loops of a region that get a scarf seam.
enum class ScarfPlacement : uint8_t {
  kNowhere,
  kContours,  ///< outer contours of islands
  kEverywhere,
};

/// Options of a scarf seam. A loop begins low and thin, rises to its full height, and ends on top
/// of its own beginning. A scarf is less visible than a butt joint.
struct ScarfOptions {
  ScarfPlacement placement = ScarfPlacement::kNowhere;  ///< setting scarf_seam_placement
  bool only_on_smooth = true;  ///< `scarf_seam_only_on_smooth`: no scarf at corners
  /// `scarf_seam_smooth_angle`: smallest angle between the edges of a loop at a start that is no
  /// corner
  double smooth_angle_deg = 150;
  /// `scarf_seam_max_overhang`, with only_on_smooth: unsupported share of the width at the start
  /// from which the loop has no scarf; 0: no limit
  double most_overhang = 0;
  bool on_inner = false;     ///< setting scarf_seam_on_inner_perimeters
  bool entire_loop = false;  ///< `scarf_seam_entire_loop`: the scarf is as long as the loop
  /// `scarf_seam_start_height`: start height as a share of the layer height
  double start_height_ratio = 0;
  double length_mm = 20;       ///< setting scarf_seam_length
  double max_segment_mm = 1;   ///< `scarf_seam_max_segment_length`: longest segment with one flow
  int32_t least_segments = 1;  ///< `scarf_seam_steps`: least number of segments of a scarf
  /// scarf_seam_speed: highest speed of a scarf; 0: speed_ratio applies.
  double speed_mm_s = 0;
  /// Used if scarf_seam_speed is a percentage: share of the wall's speed.
  double speed_ratio = 1;
  double flow = 1;  ///< scarf_seam_flow_ratio

  friend bool operator==(const ScarfOptions&, const ScarfOptions&) = default;
};

/// Returns true if a scarf depends on the layer below.
inline bool LimitsOverhang(const ScarfOptions& scarf) {
  return scarf.placement != ScarfPlacement::kNowhere && scarf.only_on_smooth &&
         scarf.most_overhang > 0;
}

/// Direction of walls over air: reversed in every second layer.
struct OverhangReversal {
  bool on = false;          ///< setting overhang_reverse
  bool inner_only = false;  ///< `overhang_reverse_internal_only`: outer walls keep their direction
  /// `overhang_reverse_threshold`: least overhang of a reversed wall; 0: all walls.
  double threshold_mm = 0;

  friend bool operator==(const OverhangReversal&, const OverhangReversal&) = default;
};

/// Returns one value for each feature.
constexpr std::array<double, kFeatureCount> ForAllFeatures(double value) {
  std::array<double, kFeatureCount> values = {};
  values.fill(value);
  return values;
}

/// Speeds, scarf seams and bridges of one region.
struct RegionMotion {
  std::array<double, kFeatureCount> speed_mm_s = {30, 60, 30, 20, 80, 20, 15, 60,
                                                  60, 60, 60, 15, 0,  0};  ///< speed per Feature
  double small_perimeter_speed_mm_s = 15;  ///< `small_perimeter_speed`: speed of small loops
  /// `small_perimeter_threshold`: radius of the largest small loop
  double small_perimeter_radius_mm = 6.5;
  bool dynamic_overhangs = false;  ///< setting enable_dynamic_overhang_speeds
  /// `overhang_speed_0` to `_3`: speed per overhang degree.
  std::array<double, kOverhangDegrees> overhang_speed_mm_s = {15, 15, 20, 25};
  ScarfOptions scarf;
  /// `overhangs`: walls with nothing below are bridges, with the speed, fan and flow of bridges.
  bool bridging_walls = false;
  double bridge_flow = 1;           ///< setting bridge_flow_ratio
  double internal_bridge_flow = 0;  ///< setting internal_bridge_flow; 0: bridge_flow
  bool thick_bridges = true;   ///< `thick_bridges`: bridges are round strands as wide as the nozzle
  double bridge_width_mm = 0;  ///< `bridge_line_width`: diameter of the strands; 0: the nozzle's
  /// external_perimeter_flow_ratio, perimeter_flow_ratio, ...: factor on the plastic per Feature.
  std::array<double, kFeatureCount> flow = ForAllFeatures(1);
  double first_layer_flow = 1;  ///< first_layer_flow_ratio: further factor in the first layer
  /// skirt_speed: speed of skirts in all layers; 0: the speed of supports. Set in the skirt's row.
  double skirt_speed_mm_s = 0;
  /// `small_support_perimeter_speed`: speed of small loops of supports; 0: small_support_ratio
  double small_support_mm_s = 0;
  double small_support_ratio = 0.5;    ///< share of the supports' speed, if given as a percentage
  double small_support_radius_mm = 0;  ///< `small_support_perimeter_threshold`; 0: no loop is small
  bool wipe_inward = false;            ///< `wipe_inward`: wipes of outer walls are shifted inwards
  Coord wipe_inward_nm = 0;            ///< `wipe_inward_distance`; 0: wipe_inward_share applies
  double wipe_inward_share = 0.5;      ///< share of the wall's width, if given as a percentage
  bool wipe_on_loops = false;  ///< `wipe_on_loops`: a move inwards at the end of outer walls
  /// `wipe_before_external_loop`: a move inwards before outer walls.
  bool wipe_before_outer = false;
  OverhangReversal reversal;
  /// Least height of beads that follow the surface (SurfaceContour); 0: all beads are level.
  Coord contour_least_nm = 0;
  /// `zaa_minimize_perimeter_height`: slope above which the outer edge of a wall, not its middle,
  /// is at the surface; 0: never
  double contour_edge_slope_rad = 0;

  friend bool operator==(const RegionMotion&, const RegionMotion&) = default;
};

}  // namespace slicefarm
