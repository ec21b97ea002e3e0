#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "common/geometry/point.h"
#include "common/model/options/ironing_options.h"

namespace slicefarm {

// Options of supports below overhangs. Member comments begin with the name of the setting (the
// name in PrusaSlicer).

/// Shape of supports.
enum class SupportStyle : uint8_t {
  kGrid,  ///< vertical columns on a coarse grid
  kSnug,  ///< vertical columns with the shape of the overhang that they support
  kTree,  ///< organic supports: branches that join towards the bed
};

/// Fill pattern of the support's body.
enum class SupportPattern : uint8_t { kRectilinear, kRectilinearGrid, kHoneycomb };

/// Fill pattern of support interfaces.
enum class InterfacePattern : uint8_t { kRectilinear, kConcentric };

/// Branches of style kTree.
struct TreeOptions {
  /// `support_tree_angle`: largest angle from the vertical
  double angle_rad = 40 * std::numbers::pi / 180;
  double slow_angle_rad =
      25 * std::numbers::pi / 180;       ///< `support_tree_angle_slow`: preferred largest angle
  Coord branch_diameter_nm = 2'000'000;  ///< setting support_tree_branch_diameter
  /// Setting support_tree_branch_diameter_angle.
  double diameter_angle_rad = 5 * std::numbers::pi / 180;
  Coord double_wall_diameter_nm = 3'000'000;  ///< setting support_tree_branch_diameter_double_wall
  Coord tip_diameter_nm = 800'000;            ///< setting support_tree_tip_diameter
  Coord branch_distance_nm = 1'000'000;       ///< setting support_tree_branch_distance
  double top_rate = 0.15;                     ///< setting support_tree_top_rate

  friend bool operator==(const TreeOptions&, const TreeOptions&) = default;
};

/// Support options of one object.
struct SupportOptions {
  bool on = false;  ///< setting support_material
  /// `support_material_auto`: true: supports overhangs by `threshold_rad`; false: supports only
  /// enforced areas
  bool automatic = true;
  SupportStyle style = SupportStyle::kGrid;  ///< setting support_material_style
  /// `support_material_threshold`: walls at a smaller angle to the horizontal are supported. 0:
  /// supports walls that overhang by more than half of the outer wall's width; for kTree, by more
  /// than two thirds.
  double threshold_rad = 0;
  /// `support_material_enforce_layers`: number of layers, from the bottom, of which all overhangs
  /// are supported
  int32_t enforced_layers = 0;
  /// `support_material_buildplate_only`: supports begin only on the bed, not on the part
  bool bed_only = false;
  bool skip_bridges = true;       ///< setting dont_support_bridges
  Coord top_gap_nm = 200'000;     ///< setting support_material_contact_distance
  Coord bottom_gap_nm = 200'000;  ///< setting support_material_bottom_contact_distance
  Coord xy_gap_nm = 225'000;      ///< setting support_material_xy_spacing
  /// `support_object_first_layer_gap`: xy_gap_nm of the first layer; below 0: xy_gap_nm
  Coord first_xy_gap_nm = -1;
  bool ignore_small = false;            ///< setting support_remove_small_overhang
  Coord closing_radius_nm = 2'000'000;  ///< setting support_material_closing_radius
  int32_t top_interface_layers = 3;     ///< setting support_material_interface_layers
  int32_t bottom_interface_layers = 3;  ///< setting support_material_bottom_interface_layers
  /// `support_material_spacing`: gap between lines of the support's body
  Coord spacing_nm = 2'500'000;
  /// Setting support_material_interface_spacing.
  Coord interface_spacing_nm = 0;
  /// Setting support_material_bottom_interface_spacing; below 0: interface_spacing_nm.
  Coord bottom_interface_spacing_nm = -1;
  /// `support_material_interface_contact_loops`: one more loop around interfaces below the object
  bool contact_loops = false;
  Coord expansion_nm = 0;  ///< `support_material_expansion`: growth of columns in x and y
  /// `support_material_max_bridge_length`: longer bridges are supported; 0: unlimited
  Coord max_bridge_nm = 0;
  /// `support_material_critical_only`: supports only islands in the air and cantilevers
  bool critical_only = false;
  /// `support_material_threshold_overlap`: share of the outer wall's width that must rest on the
  /// layer below, if threshold_rad is 0; below 0: by the style
  double threshold_overlap = -1;
  SupportPattern pattern = SupportPattern::kRectilinear;  ///< setting support_material_pattern
  /// setting support_material_interface_pattern
  InterfacePattern interface_pattern = InterfacePattern::kRectilinear;
  /// Setting support_material_angle.
  double angle_rad = 0;
  bool sheath = true;  ///< `support_material_with_sheath`: adds a line around the support's body
  Coord width_nm = 400'000;               ///< setting support_material_extrusion_width
  Coord wall_width_nm = 450'000;          ///< width of the part's outer wall
  Coord walls_nm = 0;                     ///< total thickness of the part's walls
  Coord layer_height_nm = 200'000;        ///< layer height of the object
  Coord first_layer_height_nm = 200'000;  ///< height of the first layer on the bed
  Coord min_layer_height_nm = 70'000;     ///< setting min_layer_height
  bool synchronize_layers = false;        ///< setting support_material_synchronize_layers
  TreeOptions tree = {};
  IroningOptions ironing = {};  ///< support_ironing, ...: ironing of the tops of interfaces

  friend bool operator==(const SupportOptions&, const SupportOptions&) = default;
};

/// Returns the distance of supports from a layer of a part in x and y. `bottom_nm`: height of the
/// layer's lower side above the bed.
inline Coord XyGap(const SupportOptions& options, Coord bottom_nm) {
  return bottom_nm <= 0 && options.first_xy_gap_nm >= 0 ? options.first_xy_gap_nm
                                                        : options.xy_gap_nm;
}

/// Kinds of support region. Each kind has its own row of region settings.
enum class SupportRow : uint8_t {
  kFirstLayer,  ///< layer on the bed, for any kind of support above
  kBase,
  kBranch,       ///< branch with a wall of one loop
  kThickBranch,  ///< branch with a wall of two loops
  kInterface,
  kBottomInterface,
};
inline constexpr int kSupportRowCount = 6;

/// Indices into the job's tables of region settings, indexed by SupportRow.
using SupportRows = std::array<int32_t, kSupportRowCount>;

}  // namespace slicefarm
