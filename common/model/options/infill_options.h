#pragma once

#include <algorithm>
#include <cstdint>

#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"
#include "common/model/options/bridge_options.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/options/flow_table.h"
#include "common/model/options/ironing_options.h"
#include "common/model/options/pattern_options.h"
#include "common/model/options/shell_extra.h"
#include "common/model/options/solid_options.h"
#include "common/model/options/surface_options.h"

namespace slicefarm {

/// `infill_goal`: criterion by which fill_pattern = auto chooses the pattern.
enum class FillGoal : uint8_t { kStrength, kTime, kFlexibility };

/// `ensure_vertical_shell_thickness`: sloped surfaces that get solid infill behind their walls.
enum class ShellThickness : uint8_t {
  /// no slopes: a layer is solid only where a surface at least one bead wide is exposed
  kDisabled,
  /// gentle slopes: within the solid layers, the outline recedes by three bead widths or more
  kPartial,
  kEnabled,  ///< all slopes
};

/// Number of layers below a layer that the infill over bridges reads. A bridge in the layer below
/// spans a gap in the layer under it.
inline constexpr int32_t kOverBridgeHaloLayers = 2;

/// Options for the infill of one region. Member comments begin with the name of the setting.
struct InfillOptions {
  int32_t top_solid_layers = 5;     ///< setting top_solid_layers
  int32_t bottom_solid_layers = 5;  ///< setting bottom_solid_layers
  /// top and bottom solid layers that may be left out (shell_extra.h)
  ShellExtra top_spare = {}, bottom_spare = {};
  double density = 0.2;                      ///< setting fill_density, in [0, 1]
  FillPattern pattern = FillPattern::kGrid;  ///< setting fill_pattern
  /// `fill_pattern = auto`: planning chooses a pattern for each object
  bool choose_pattern = false;
  FillGoal goal = FillGoal::kStrength;  ///< setting infill_goal
  PatternOptions shape = {};
  LockedZagOptions zones = {};
  SolidOptions solid = {};
  SurfaceOptions surfaces = {};
  BridgeOptions bridges = {};
  /// `solid_fill_pattern`: pattern of solid infill inside the part
  FillPattern solid_pattern = FillPattern::kRectilinear;
  FillPattern top_pattern = FillPattern::kMonotonic;     ///< setting top_fill_pattern
  FillPattern bottom_pattern = FillPattern::kMonotonic;  ///< setting bottom_fill_pattern
  /// Setting fill_angle. The angle of solid layers changes by 90 degrees from layer to layer.
  double angle_rad = 0.78539816339744831;
  double solid_angle_rad =
      -1;  ///< `solid_fill_angle`: angle_rad of solid infill; below 0: angle_rad
  /// `zaa_dont_alternate_fill_direction`: lines keep their direction from layer to layer
  bool same_direction = false;
  /// `fill_angle_template`, `solid_fill_angle_template`: canonical texts (fill_angles.h). Empty: no
  /// template.
  SharedText angle_template = {};
  SharedText solid_angle_template = {};
  /// `align_infill_direction_to_model`: directions of lines turn with the copies of the object
  bool follows_model = false;
  double turn_rad = 0;  ///< turn of the copies that have this row, if the lines follow the model
  Coord sparse_width_nm = 450'000;       ///< setting infill_extrusion_width
  Coord solid_width_nm = 450'000;        ///< setting solid_infill_extrusion_width
  Coord top_width_nm = 450'000;          ///< setting top_infill_extrusion_width
  Coord first_layer_width_nm = 450'000;  ///< setting first_layer_extrusion_width
  /// `infill_overlap`: length by which the ends of lines extend into the walls
  Coord overlap_nm = 112'500;
  /// `top_bottom_infill_overlap`: overlap_nm of top and bottom surfaces; below 0: overlap_nm
  Coord surface_overlap_nm = -1;
  double solid_below_area_mm2 =
      0;  ///< `solid_infill_below_area`: regions of sparse infill with a smaller area become solid
  /// `infill_anchor`: length by which a line without a link is extended along the wall
  Coord anchor_nm = 2'700'000;
  /// `infill_anchor_max`: longest link of two lines along the wall; 0: no links
  Coord anchor_max_nm = 50'000'000;
  /// `infill_smoothing`: smoothing of the lines of pattern medialaxis; 0: no smoothing
  Coord smoothing_nm = 0;
  /// Setting solid_infill_every_layers; 0: no additional solid layers.
  int32_t solid_every_layers = 0;
  /// Setting bridge_angle; 0: a direction is computed for each bridge.
  double bridge_angle_rad = 0;
  double bridge_flow = 1;  ///< `bridge_flow_ratio`: factor on the plastic of bridges
  double top_flow = 1;     ///< `top_solid_infill_flow_ratio`: factor on the plastic of top skins
  /// `thick_bridges`: bridge beads are round, with the nozzle's diameter
  bool thick_bridges = true;
  /// `bottom_solid_infill_flow_ratio`: factor on the plastic of bottom skins
  double bottom_flow = 1;
  double bridge_density = 1;  ///< `bridge_density`: share of a bridge's area under its lines
  double internal_bridge_density = 1;  ///< setting internal_bridge_density
  Coord walls_nm = 0;                  ///< total thickness of the walls around the infill
  /// `over_bridge_speed`: solid infill over bridges is a separate feature
  bool over_bridges = false;
  /// `internal_bridge_speed`: true if bridges over sparse infill are a feature of their own
  bool internal_bridges = false;
  /// `internal_bridge_flow`: factor on the plastic of bridges over sparse infill; 0: bridge_flow
  double internal_bridge_flow = 0;
  /// `thick_internal_bridges`: thick_bridges for bridges over sparse infill
  bool thick_internal_bridges = true;
  /// `interface_shells`: also makes skins where the region touches other regions
  bool interface_shells = false;
  Coord nozzle_nm = 400'000;  ///< setting nozzle_diameter
  /// `infill_every_layers`: number of layers that share one sparse infill, in the topmost of them
  int32_t every_layers = 1;
  bool only_where_needed = false;                    ///< setting infill_only_where_needed
  ShellThickness shells = ShellThickness::kEnabled;  ///< setting ensure_vertical_shell_thickness
  bool overhang_lines = false;                       ///< setting extra_perimeters_on_overhangs
  IroningOptions ironing = {};
  bool small_area_flow = false;  ///< setting small_area_infill_flow_compensation
  /// `small_area_infill_flow_compensation_model`: canonical text (flow_table.h).
  SharedText small_area_flow_table = kSmallAreaFlowTable;
  /// `density_field`, `stress_field`: canonical texts (fields/field_text.h). Empty: no field.
  SharedText density_field = {};
  SharedText stress_field = {};
  /// Number of layers above and below a layer that density_field needs to compute the distance to
  /// the surface.
  int32_t field_halo_layers = 0;

  friend bool operator==(const InfillOptions&, const InfillOptions&) = default;
};

/// Returns the number of lines side by side in place of each line of a pattern.
inline int32_t LinesOf(const InfillOptions& options, FillPattern pattern) {
  return TakesSeveralLines(pattern) ? options.shape.lines : 1;
}

/// Returns the density of the sparse infill where it is least dense.
inline double LeastDensity(const InfillOptions& options) {
  if (options.pattern != FillPattern::kLockedZag || options.density <= 0) return options.density;
  return std::min(options.zones.skin_density, options.zones.skeleton_density);
}

/// Returns true if skins over sparse infill are bridges, because the gaps between the sparse lines
/// are at least two beads wide. Returns false if the density or the lines follow a field.
inline bool BridgesSparse(const InfillOptions& options) {
  const int32_t lines = LinesOf(options, options.pattern);
  return LeastDensity(options) <= lines / (lines + 2.0) && options.density_field.empty() &&
         options.stress_field.empty();
}

/// Returns true if patterns are laid out around the middles of connected bodies.
inline bool NeedsBodies(const InfillOptions& options) {
  return options.shape.separated ||
         (options.surfaces.center == SurfaceCenter::kBody &&
          (IsSpiral(options.top_pattern) || IsSpiral(options.bottom_pattern)));
}

/// Returns true if planning decides about the infill: the pattern of the sparse infill, its lines,
/// the layers that have it, or the places of patterns.
inline bool NeedsPlan(const InfillOptions& options) {
  return options.choose_pattern || InfoOf(options.pattern).planned || options.every_layers > 1 ||
         options.only_where_needed || NeedsBodies(options);
}

}  // namespace slicefarm
