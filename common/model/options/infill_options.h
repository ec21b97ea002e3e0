#pragma once

#include <cstdint>

#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/options/flow_table.h"
#include "common/model/options/skin_spare.h"

namespace slicefarm {

/// infill_goal: what fill_pattern = auto is to serve.
enum class FillGoal : uint8_t { kStrength, kTime, kFlexibility };

/// ironing_type: which surfaces are ironed.
enum class IroningType : uint8_t {
  kTop,      ///< all top surfaces
  kTopmost,  ///< those of an object's last layer
  kSolid,    ///< all solid infill
};

/// Smooths what is printed by going over it once more, with little plastic.
struct IroningOptions {
  bool enabled = false;                  ///< ironing
  IroningType type = IroningType::kTop;  ///< ironing_type
  double flow = 0.15;                    ///< ironing_flowrate: share of what would fill the layer
  Coord spacing_nm = 100'000;            ///< ironing_spacing: distance of the lines

  friend bool operator==(const IroningOptions&, const IroningOptions&) = default;
};

/// ensure_vertical_shell_thickness: which slopes have solid infill behind their walls.
enum class ShellThickness : uint8_t {
  kDisabled,  ///< none: only what lies under (over) a surface at least a bead wide is solid
  kPartial,   ///< gentle ones: their treads, over as many layers as are solid, are three beads wide
  kEnabled,   ///< all
};

/// A bridge is where the layer below it is bare: two below what lies over it.
inline constexpr int32_t kOverBridgeHaloLayers = 2;

struct InfillOptions {
  int32_t top_solid_layers = 5;                 ///< top_solid_layers
  int32_t bottom_solid_layers = 5;              ///< bottom_solid_layers
  SkinSpare top_spare = {}, bottom_spare = {};  ///< of these layers
  double density = 0.2;                         ///< fill_density, [0, 1]
  FillPattern pattern = FillPattern::kGrid;     ///< fill_pattern
  bool choose_pattern = false;          ///< fill_pattern = auto: planning names one for each object
  FillGoal goal = FillGoal::kStrength;  ///< infill_goal
  FillPattern solid_pattern = FillPattern::kRectilinear;  ///< inside: solid_fill_pattern
  FillPattern top_pattern = FillPattern::kMonotonic;      ///< top_fill_pattern
  FillPattern bottom_pattern = FillPattern::kMonotonic;   ///< bottom_fill_pattern
  double angle_rad =
      0.78539816339744831;  ///< fill_angle; solid layers turn by a right angle from layer to layer
  /// fill_angle_template, solid_fill_angle_template: canonical texts (fill_angles.h); empty: none.
  SharedText angle_template = {};
  SharedText solid_angle_template = {};
  Coord sparse_width_nm = 450'000;       ///< infill_extrusion_width
  Coord solid_width_nm = 450'000;        ///< solid_infill_extrusion_width
  Coord top_width_nm = 450'000;          ///< top_infill_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< first_layer_extrusion_width
  Coord overlap_nm = 112'500;  ///< infill_overlap: how far the lines' ends reach into the walls
  double solid_below_area_mm2 =
      0;                        ///< solid_infill_below_area: smaller sparse regions become solid
  Coord anchor_nm = 2'700'000;  ///< infill_anchor: of a line's end that is not linked
  Coord anchor_max_nm = 50'000'000;  ///< infill_anchor_max: longest link; 0: none
  Coord smoothing_nm = 0;            ///< infill_smoothing: of medialaxis' lines; 0: none
  int32_t solid_every_layers = 0;    ///< solid_infill_every_layers; 0: none
  double bridge_angle_rad = 0;       ///< bridge_angle; 0: found for each bridge
  double bridge_flow = 1;            ///< bridge_flow_ratio: plastic of bridges' beads
  double top_flow = 1;               ///< top_solid_infill_flow_ratio: plastic of top skins
  bool thick_bridges = true;         ///< thick_bridges: round threads as wide as the nozzle
  Coord walls_nm = 0;                ///< how thick the walls are about which it lies
  bool over_bridges = false;       ///< over_bridge_speed: solid infill over bridges goes by itself
  bool interface_shells = false;   ///< interface_shells: skins where another region begins
  Coord nozzle_nm = 400'000;       ///< nozzle_diameter
  int32_t every_layers = 1;        ///< infill_every_layers: that many are filled at once
  bool only_where_needed = false;  ///< infill_only_where_needed
  ShellThickness shells = ShellThickness::kEnabled;  ///< ensure_vertical_shell_thickness
  bool overhang_lines = false;                       ///< extra_perimeters_on_overhangs
  IroningOptions ironing = {};
  bool small_area_flow = false;  ///< small_area_infill_flow_compensation
  /// small_area_infill_flow_compensation_model: a canonical text (flow_table.h).
  SharedText small_area_flow_table = kSmallAreaFlowTable;
  /// density_field, stress_field: canonical texts (fields/field_text.h); empty: none.
  SharedText density_field = {};
  SharedText stress_field = {};
  /// How many layers above and below density_field looks at for the distance to the surface.
  int32_t field_halo_layers = 0;

  friend bool operator==(const InfillOptions&, const InfillOptions&) = default;
};

/// Whether skins over sparse infill are bridges: where two beads and more would have room between
/// its lines. What fields say of densities is not looked at.
inline bool BridgesSparse(const InfillOptions& options) {
  constexpr double kDensest = 1.0 / 3;
  return options.density <= kDensest && options.density_field.empty() &&
         options.stress_field.empty();
}

/// Returns true if planning decides about the sparse infill: its pattern, its lines or its layers.
inline bool NeedsPlan(const InfillOptions& options) {
  return options.choose_pattern || InfoOf(options.pattern).planned || options.every_layers > 1 ||
         options.only_where_needed;
}

}  // namespace slicefarm
