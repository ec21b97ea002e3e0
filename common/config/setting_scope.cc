#include "common/config/setting_scope.h"

#include <algorithm>

namespace slicefarm::config {
namespace {

constexpr std::string_view kOfObjects[] = {
    "brim_ears_detection_length",
    "brim_ears_max_angle",
    "brim_separation",
    "brim_type",
    "brim_width",
    "elefant_foot_compensation",
    "extrusion_width",
    "layer_height",
    "lock_outer_width",
    "max_bead_width",
    "min_bead_width",
    "min_feature_size",
    "perimeter_generator",
    "raft_contact_distance",
    "raft_expansion",
    "raft_first_layer_density",
    "raft_first_layer_expansion",
    "raft_layers",
    "seam_position",
    "slice_closing_radius",
    "slicing_mode",
    "support_material_angle",
    "support_material_extrusion_width",
    "support_material_interface_speed",
    "support_material_spacing",
    "support_material_speed",
    "wall_distribution_count",
    "wall_transition_angle",
    "wall_transition_filter_deviation",
    "wall_transition_length",
    "xy_hole_compensation",
    "xy_size_compensation",
};

constexpr std::string_view kOfRegions[] = {
    "alternate_hatch",
    "beam_compensation",
    "bottom_fill_pattern",
    "bottom_solid_layers",
    "bottom_solid_min_thickness",
    "bridge_speed",
    "contour_distance",
    "contour_focus",
    "contour_frequency",
    "contour_point_delay",
    "contour_point_distance",
    "contour_point_time",
    "contour_power",
    "contour_speed",
    "contours",
    "contours_first",
    "decompose_method",
    "density_field",
    "downskin_focus",
    "downskin_frequency",
    "downskin_layers",
    "downskin_point_delay",
    "downskin_point_distance",
    "downskin_point_time",
    "downskin_power",
    "downskin_speed",
    "external_perimeter_extrusion_width",
    "external_perimeter_speed",
    "external_perimeters_first",
    "fill_angle",
    "fill_density",
    "fill_pattern",
    "gap_fill_enabled",
    "gap_fill_max_width",
    "gap_fill_min_width",
    "gap_fill_speed",
    "hatch_angle",
    "hatch_distance",
    "hatch_focus",
    "hatch_frequency",
    "hatch_offset",
    "hatch_point_delay",
    "hatch_point_distance",
    "hatch_point_time",
    "hatch_power",
    "hatch_rotation",
    "hatch_speed",
    "infill_extrusion_width",
    "infill_overlap",
    "infill_speed",
    "inner_outer_inner",
    "island_width",
    "jump_delay",
    "jump_order",
    "jump_speed",
    "laser_spot",
    "link_rings",
    "mark_delay",
    "minimum_vector",
    "perimeter_extrusion_width",
    "perimeter_speed",
    "perimeters",
    "polygon_delay",
    "ring_corners",
    "ring_overlap",
    "scan_overlap",
    "scan_strategy",
    "skin_overlap",
    "skywriting",
    "small_perimeter_speed",
    "solid_fill_pattern",
    "solid_infill_below_area",
    "solid_infill_extrusion_width",
    "solid_infill_speed",
    "stress_field",
    "stripe_width",
    "thin_wall_exposure",
    "thin_wall_focus",
    "thin_wall_frequency",
    "thin_wall_point_delay",
    "thin_wall_point_distance",
    "thin_wall_point_time",
    "thin_wall_power",
    "thin_wall_speed",
    "thin_walls",
    "top_fill_pattern",
    "top_infill_extrusion_width",
    "top_solid_infill_speed",
    "top_solid_layers",
    "top_solid_min_thickness",
    "upskin_focus",
    "upskin_frequency",
    "upskin_layers",
    "upskin_point_delay",
    "upskin_point_distance",
    "upskin_point_time",
    "upskin_power",
    "upskin_speed",
};

}  // namespace

Scope ScopeOf(std::string_view key) {
  if (std::ranges::binary_search(kOfRegions, key)) return Scope::kRegion;
  if (std::ranges::binary_search(kOfObjects, key)) return Scope::kObject;
  return Scope::kJob;
}

std::string_view ScopeName(Scope scope) {
  switch (scope) {
    case Scope::kJob:
      return "the job";
    case Scope::kObject:
      return "an object";
    default:
      return "a region";
  }
}

}  // namespace slicefarm::config
