#pragma once

#include <cstdint>
#include <numbers>

#include "common/geometry/point.h"

namespace slicefarm {

/// Names in the comments are PrusaSlicer's settings.

enum class SupportStyle : uint8_t {
  kGrid,  ///< columns as wide as whole cells of a grid: few corners, steady
  kSnug,  ///< columns under what they carry alone
  kTree,  ///< organic: branches that lean and meet
};

/// How branches grow.
struct TreeSupportOptions {
  double angle_rad = 40 * std::numbers::pi / 180;  ///< support_tree_angle: the most they lean
  double slow_angle_rad =
      25 * std::numbers::pi / 180;       ///< support_tree_angle_slow: if free to choose
  Coord branch_diameter_nm = 2'000'000;  ///< support_tree_branch_diameter
  /// support_tree_branch_diameter_angle: how fast the diameter grows downwards.
  double diameter_angle_rad = 5 * std::numbers::pi / 180;
  Coord double_wall_diameter_nm = 3'000'000;  ///< support_tree_branch_diameter_double_wall
  Coord tip_diameter_nm = 800'000;            ///< support_tree_tip_diameter
  Coord branch_distance_nm = 1'000'000;       ///< support_tree_branch_distance: between tips
  double top_rate = 0.15;                     ///< support_tree_top_rate: share that tips cover

  friend bool operator==(const TreeSupportOptions&, const TreeSupportOptions&) = default;
};

/// How one object is supported. What PrusaSlicer gives as a share or as "the same as" is resolved.
struct SupportOptions {
  SupportStyle style = SupportStyle::kGrid;  ///< support_material_style
  bool automatic = true;                     ///< support_material_auto: not only where enforced
  double threshold_rad = 0;  ///< support_material_threshold, from level; 0: half of wall_width_nm
  Coord wall_width_nm = 450'000;               ///< of the part's outer wall
  int32_t enforce_layers = 0;                  ///< support_material_enforce_layers
  bool build_plate_only = false;               ///< support_material_buildplate_only
  bool leave_bridges = true;                   ///< dont_support_bridges
  Coord contact_distance_nm = 200'000;         ///< support_material_contact_distance
  Coord bottom_contact_distance_nm = 200'000;  ///< support_material_bottom_contact_distance
  Coord xy_spacing_nm = 225'000;               ///< support_material_xy_spacing
  Coord closing_radius_nm = 2'000'000;         ///< support_material_closing_radius
  int32_t interface_layers = 3;                ///< support_material_interface_layers
  int32_t bottom_interface_layers = 3;         ///< support_material_bottom_interface_layers
  bool synchronize_layers = false;             ///< support_material_synchronize_layers
  Coord first_layer_height_nm = 200'000;       ///< first_layer_height
  Coord layer_height_nm = 200'000;             ///< no layer of support is higher
  Coord min_layer_height_nm = 70'000;          ///< min_layer_height: nor lower
  Coord line_width_nm = 350'000;               ///< support_material_extrusion_width
  Coord spacing_nm = 2'500'000;                ///< support_material_spacing: a cell of the grid
  double angle_rad = 0;                        ///< support_material_angle
  TreeSupportOptions tree;

  friend bool operator==(const SupportOptions&, const SupportOptions&) = default;
};

}  // namespace slicefarm
