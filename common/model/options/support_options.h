#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "common/geometry/point.h"

namespace slicefarm {

/// Supports below what would hang in the air. Names in the comments are the settings'
/// (PrusaSlicer's).

enum class SupportStyle : uint8_t {
  kGrid,  ///< columns on a coarse grid
  kSnug,  ///< columns as wide as what they carry
  kTree,  ///< organic: branches
};

enum class SupportPattern : uint8_t { kRectilinear, kRectilinearGrid, kHoneycomb };

enum class InterfacePattern : uint8_t { kRectilinear, kConcentric };

/// Branches of style kTree.
struct TreeOptions {
  double angle_rad = 40 * std::numbers::pi / 180;  ///< support_tree_angle: at most, from upright
  double slow_angle_rad =
      25 * std::numbers::pi / 180;       ///< support_tree_angle_slow: if it can be had
  Coord branch_diameter_nm = 2'000'000;  ///< support_tree_branch_diameter
  double diameter_angle_rad = 5 * std::numbers::pi / 180;  ///< support_tree_branch_diameter_angle
  Coord double_wall_diameter_nm = 3'000'000;  ///< support_tree_branch_diameter_double_wall
  Coord tip_diameter_nm = 800'000;            ///< support_tree_tip_diameter
  Coord branch_distance_nm = 1'000'000;       ///< support_tree_branch_distance
  double top_rate = 0.15;                     ///< support_tree_top_rate

  friend bool operator==(const TreeOptions&, const TreeOptions&) = default;
};

/// What supports of one object are like.
struct SupportOptions {
  bool on = false;        ///< support_material
  bool automatic = true;  ///< support_material_auto: by the threshold too, not only as enforced
  SupportStyle style = SupportStyle::kGrid;  ///< support_material_style
  /// support_material_threshold: walls that rise less steeply are supported; 0: those that hang
  /// over by more than half of the outer wall's width.
  double threshold_rad = 0;
  int32_t enforced_layers = 0;    ///< support_material_enforce_layers: whatever the threshold
  bool bed_only = false;          ///< support_material_buildplate_only: none stands on the part
  bool skip_bridges = true;       ///< dont_support_bridges
  Coord top_gap_nm = 200'000;     ///< support_material_contact_distance
  Coord bottom_gap_nm = 200'000;  ///< support_material_bottom_contact_distance
  Coord xy_gap_nm = 225'000;      ///< support_material_xy_spacing
  Coord closing_radius_nm = 2'000'000;  ///< support_material_closing_radius
  int32_t top_interface_layers = 3;     ///< support_material_interface_layers
  int32_t bottom_interface_layers = 3;  ///< support_material_bottom_interface_layers
  Coord spacing_nm = 2'500'000;    ///< support_material_spacing: free between lines of the body
  Coord interface_spacing_nm = 0;  ///< support_material_interface_spacing
  SupportPattern pattern = SupportPattern::kRectilinear;  ///< support_material_pattern
  InterfacePattern interface_pattern = InterfacePattern::kRectilinear;  ///< ..._interface_pattern
  double angle_rad = 0;                                                 ///< support_material_angle
  bool sheath = true;               ///< support_material_with_sheath: a line runs round the body
  Coord width_nm = 400'000;         ///< support_material_extrusion_width
  Coord wall_width_nm = 450'000;    ///< of the part's outer wall
  Coord walls_nm = 0;               ///< how thick all its walls are together
  Coord layer_height_nm = 200'000;  ///< the object's
  Coord first_layer_height_nm = 200'000;  ///< of what stands on the bed
  Coord min_layer_height_nm = 70'000;     ///< min_layer_height
  bool synchronize_layers = false;        ///< support_material_synchronize_layers
  TreeOptions tree = {};

  friend bool operator==(const SupportOptions&, const SupportOptions&) = default;
};

/// How regions of support are printed.
enum class SupportRow : uint8_t {
  kFirstLayer,  ///< on the bed, whatever is above
  kBase,
  kBranch,       ///< one loop
  kThickBranch,  ///< two loops
  kInterface,
};
inline constexpr int kSupportRowCount = 5;

/// Rows of the job's tables of region settings, by SupportRow.
using SupportRows = std::array<int32_t, kSupportRowCount>;

}  // namespace slicefarm
