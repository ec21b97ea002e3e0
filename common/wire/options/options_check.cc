#include "common/wire/options/options_check.h"

#include <cmath>
#include <string>
#include <string_view>

#include "common/model/limits.h"
#include "common/model/options/advance_model.h"
#include "common/model/options/beading_options.h"
#include "common/model/options/flow_fit.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/region_motion.h"
#include "common/model/options/slicing_options.h"
#include "common/model/options/tool_row.h"
#include "common/wire/options/value_checks.h"
#include "common/wire/support/wire_error.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm {
namespace {

constexpr double kMaxTransitionAngle = 1.6;  // radians: a right angle
constexpr double kRightAngle = 1.5708;
constexpr double kMostLightningAngle = 1.5;  // radians: 86 degrees
constexpr int kMostOctaves = 10;
constexpr int kMostLinesSideBySide = 10;
constexpr double kLeastLean = 0.26, kMostLean = 1.31;  // radians: 15 and 75 degrees

absl::Status CheckProfile(const std::vector<LayerHeightAt>& profile) {
  Coord least = 0;
  for (const LayerHeightAt& at : profile) {
    if (at.z_nm < least || at.z_nm > limits::kMaxCoord || at.height_nm <= 0 ||
        at.height_nm > limits::kMaxCoord)
      return Malformed("height_profile", "is no list of heights by z, upwards");
    least = at.z_nm;
  }
  return CheckRange("height_profile", static_cast<double>(profile.size()), 0,
                    kMaxLayerHeightPoints);
}

absl::Status CheckAdaptive(const AdaptiveHeights& adaptive) {
  absl::Status status =
      CheckPositive({{"adaptive.cusp_nm", adaptive.cusp_nm}, {"adaptive.min_nm", adaptive.min_nm}});
  status.Update(CheckLengths({{"adaptive.max_nm", adaptive.max_nm}}, adaptive.min_nm));
  status.Update(CheckRange("adaptive.max_ratio", adaptive.max_ratio, 1, kMostHeightRatio));
  return status;
}

absl::Status CheckSlicedObject(const ObjectSlicingOptions& object) {
  absl::Status status = CheckPositive({{"layer_height_nm", object.layer_height_nm}});
  status.Update(
      CheckNotNegative({{"closing_radius_nm", object.closing_radius_nm},
                        {"lift_nm", object.lift_nm},
                        {"elephant_foot_min_width_nm", object.elephant_foot_min_width_nm}}));
  status.Update(CheckLengths({{"xy_compensation_nm", object.xy_compensation_nm},
                              {"hole_compensation_nm", object.hole_compensation_nm},
                              {"elephant_foot_nm", object.elephant_foot_nm}},
                             -limits::kMaxCoord));
  status.Update(CheckRange("hollow_from", object.hollow_from, 0, limits::kMaxLayers));
  status.Update(CheckAdaptive(object.adaptive));
  status.Update(CheckProfile(object.height_profile));
  status.Update(CheckPositive({{"polyholes.nozzle_nm", object.polyholes.nozzle_nm}}));
  status.Update(CheckNotNegative({{"polyholes.threshold_nm", object.polyholes.threshold_nm}}));
  status.Update(CheckNoLessThanZero("polyholes.threshold_share", object.polyholes.threshold_share));
  status.Update(CheckRange("printable.angle_rad", object.printable.angle_rad, 0, kRightAngle));
  return status;
}

absl::Status CheckThumbnails(const std::vector<ThumbnailSize>& thumbnails) {
  absl::Status status = CheckRange("thumbnails", static_cast<double>(thumbnails.size()), 0,
                                   limits::kMaxThumbnails + limits::kMaxPlatePictures);
  for (const auto& [width, height, format, role] : thumbnails)
    for (const int32_t px : {width, height})
      status.Update(CheckRange("thumbnails", px, 1, limits::kMaxThumbnailPx));
  return status;
}

absl::Status CheckTexture(const FuzzyTexture& texture) {
  absl::Status status = CheckAboveZero("texture.scale_mm", texture.scale_mm);
  status.Update(CheckRange("texture.octaves", texture.octaves, 1, kMostOctaves));
  status.Update(CheckNoLessThanZero("texture.persistence", texture.persistence));
  status.Update(CheckAboveZero("texture.ripples", texture.ripples));
  status.Update(CheckAboveZero("texture.ripple_layers", texture.ripple_layers));
  return status;
}

absl::Status CheckWalls(const BeadingOptions& walls) {
  absl::Status status = CheckRange("perimeters", walls.perimeters, 0, limits::kMaxPerimeters);
  status.Update(CheckPositive({{"external_width_nm", walls.external_width_nm},
                               {"inner_width_nm", walls.inner_width_nm},
                               {"first_layer_width_nm", walls.first_layer_width_nm},
                               {"fuzzy_point_distance_nm", walls.fuzzy_point_distance_nm}}));
  status.Update(CheckNotNegative({{"fuzzy_thickness_nm", walls.fuzzy_thickness_nm},
                                  {"min_gap_width_nm", walls.min_gap_width_nm},
                                  {"max_gap_width_nm", walls.max_gap_width_nm},
                                  {"transition_length_nm", walls.transition_length_nm},
                                  {"transition_deviation_nm", walls.transition_deviation_nm},
                                  {"min_feature_nm", walls.min_feature_nm},
                                  {"min_bead_width_nm", walls.min_bead_width_nm},
                                  {"min_gap_length_nm", walls.min_gap_length_nm},
                                  {"min_top_width_nm", walls.min_top_width_nm},
                                  {"first_layer_min_bead_nm", walls.first_layer_min_bead_nm},
                                  {"max_bead_width_nm", walls.max_bead_width_nm}}));
  status.Update(CheckTexture(walls.texture));
  status.Update(CheckNoLessThanZero("min_length_factor", walls.min_length_factor));
  status.Update(CheckNotNegative(
      {{"least_edge_nm", walls.least_edge_nm}, {"edge_deviation_nm", walls.edge_deviation_nm}}));
  status.Update(CheckAboveZero("transition_angle", walls.transition_angle));
  status.Update(CheckRange("transition_angle", walls.transition_angle, 0, kMaxTransitionAngle));
  status.Update(
      CheckRange("distribution_count", walls.distribution_count, 1, limits::kMaxPerimeters));
  return status;
}

absl::Status CheckSkins(const InfillOptions& infill) {
  absl::Status status =
      CheckRange("top_solid_layers", infill.top_solid_layers, 0, limits::kMaxLayers);
  status.Update(
      CheckRange("bottom_solid_layers", infill.bottom_solid_layers, 0, limits::kMaxLayers));
  for (const ShellExtra& spare : {infill.top_spare, infill.bottom_spare}) {
    status.Update(CheckRange("spare.layers", spare.layers, 0, limits::kMaxLayers));
    status.Update(CheckNotNegative({{"spare.enough_nm", spare.enough_nm}}));
  }
  return status;
}

absl::Status CheckShape(const PatternOptions& shape, const LockedZagOptions& zones) {
  absl::Status status = CheckRange("shape.lines", shape.lines, 1, kMostLinesSideBySide);
  status.Update(CheckRange("shape.lattice_1_rad", std::abs(shape.lattice_1_rad), 0, kMostLean));
  status.Update(CheckRange("shape.lattice_2_rad", std::abs(shape.lattice_2_rad), 0, kMostLean));
  status.Update(CheckRange("shape.honeycomb_rad", shape.honeycomb_rad, kLeastLean, kMostLean));
  status.Update(CheckRange("shape.smooth", shape.smooth, 0, 1));
  status.Update(
      CheckRange("shape.gyroid_waves", shape.gyroid_waves, kLeastGyroidWaves, kMostGyroidWaves));
  for (const double angle_rad :
       {shape.lightning_overhang_rad, shape.lightning_prune_rad, shape.lightning_straighten_rad})
    status.Update(CheckRange("shape.lightning_rad", angle_rad, 0, kMostLightningAngle));
  status.Update(CheckRange("zones.skin_density", zones.skin_density, 0, 1));
  status.Update(CheckRange("zones.skeleton_density", zones.skeleton_density, 0, 1));
  status.Update(CheckPositive({{"zones.skin_width_nm", zones.skin_width_nm},
                               {"zones.skeleton_width_nm", zones.skeleton_width_nm}}));
  status.Update(CheckNotNegative({{"shape.shift_nm", shape.shift_nm},
                                  {"zones.skin_depth_nm", zones.skin_depth_nm},
                                  {"zones.lock_depth_nm", zones.lock_depth_nm}}));
  return status;
}

absl::Status CheckSurfaces(const InfillOptions& infill) {
  absl::Status status = CheckRange("solid.foot_density", infill.solid.foot_density, 0, 1);
  status.Update(CheckAboveZero("solid.foot_density", infill.solid.foot_density));
  status.Update(CheckRange("solid.foot_layers", infill.solid.foot_layers, 1, limits::kMaxLayers));
  status.Update(
      CheckNotNegative({{"surfaces.expansion_nm", infill.surfaces.expansion_nm},
                        {"surfaces.expansion_margin_nm", infill.surfaces.expansion_margin_nm},
                        {"bridges.width_nm", infill.bridges.width_nm}}));
  return status;
}

absl::Status CheckInfill(const InfillOptions& infill) {
  absl::Status status = CheckSkins(infill);
  status.Update(CheckSurfaces(infill));
  status.Update(CheckRange("field_halo_layers", infill.field_halo_layers, 0, limits::kMaxLayers));
  status.Update(CheckRange("density", infill.density, 0, 1));
  status.Update(CheckShape(infill.shape, infill.zones));
  status.Update(CheckRange("solid.top_density", infill.solid.top_density, 0, 1));
  status.Update(CheckRange("solid.bottom_density", infill.solid.bottom_density, 0, 1));
  status.Update(CheckNoLessThanZero("solid_below_area_mm2", infill.solid_below_area_mm2));
  status.Update(CheckPositive({{"sparse_width_nm", infill.sparse_width_nm},
                               {"solid_width_nm", infill.solid_width_nm},
                               {"top_width_nm", infill.top_width_nm},
                               {"first_layer_width_nm", infill.first_layer_width_nm},
                               {"nozzle_nm", infill.nozzle_nm},
                               {"ironing.spacing_nm", infill.ironing.spacing_nm}}));
  status.Update(CheckLengths({{"overlap_nm", infill.overlap_nm}}, -limits::kMaxCoord));
  status.Update(CheckNotNegative({{"anchor_nm", infill.anchor_nm},
                                  {"anchor_max_nm", infill.anchor_max_nm},
                                  {"smoothing_nm", infill.smoothing_nm},
                                  {"ironing.inset_nm", infill.ironing.inset_nm}}));
  status.Update(
      CheckLengths({{"ironing.expansion_nm", infill.ironing.expansion_nm}}, -limits::kMaxCoord));
  status.Update(CheckNoLessThanZero("solid_every_layers", infill.solid_every_layers));
  status.Update(CheckAboveZero("every_layers", infill.every_layers));
  status.Update(CheckAboveZero("bridge_flow", infill.bridge_flow));
  status.Update(CheckAboveZero("top_flow", infill.top_flow));
  status.Update(CheckAboveZero("bottom_flow", infill.bottom_flow));
  status.Update(CheckAboveZero("bridge_density", infill.bridge_density));
  status.Update(CheckAboveZero("internal_bridge_density", infill.internal_bridge_density));
  status.Update(CheckNoLessThanZero("internal_bridge_flow", infill.internal_bridge_flow));
  status.Update(CheckNoLessThanZero("ironing.flow", infill.ironing.flow));
  return status;
}

absl::Status CheckSpeeds(const RegionMotion& speeds) {
  absl::Status status = CheckAboveZero("bridge_flow", speeds.bridge_flow);
  status.Update(CheckNoLessThanZero("internal_bridge_flow", speeds.internal_bridge_flow));
  status.Update(CheckNoLessThanZero("small_perimeter_radius_mm", speeds.small_perimeter_radius_mm));
  for (const double flow : speeds.flow) status.Update(CheckAboveZero("flow", flow));
  status.Update(CheckAboveZero("first_layer_flow", speeds.first_layer_flow));
  status.Update(CheckNoLessThanZero("skirt_speed_mm_s", speeds.skirt_speed_mm_s));
  status.Update(CheckNoLessThanZero("reversal.threshold_mm", speeds.reversal.threshold_mm));
  status.Update(CheckAboveZero("scarf.least_segments", speeds.scarf.least_segments));
  status.Update(CheckAboveZero("scarf.flow", speeds.scarf.flow));
  status.Update(CheckNoLessThanZero("scarf.speed_mm_s", speeds.scarf.speed_mm_s));
  for (const double speed : speeds.speed_mm_s)
    status.Update(CheckNoLessThanZero("speed_mm_s", speed));
  for (const double speed : speeds.overhang_speed_mm_s)
    status.Update(CheckNoLessThanZero("overhang_speed_mm_s", speed));
  status.Update(CheckRange("scarf.smooth_angle_deg", speeds.scarf.smooth_angle_deg, 0, 180));
  status.Update(CheckRange("scarf.most_overhang", speeds.scarf.most_overhang, 0, 1));
  status.Update(CheckNoLessThanZero("small_support_mm_s", speeds.small_support_mm_s));
  status.Update(CheckAboveZero("small_support_ratio", speeds.small_support_ratio));
  status.Update(CheckNoLessThanZero("small_support_radius_mm", speeds.small_support_radius_mm));
  status.Update(CheckNoLessThanZero("wipe_inward_share", speeds.wipe_inward_share));
  status.Update(CheckNotNegative({{"wipe_inward_nm", speeds.wipe_inward_nm}}));
  status.Update(CheckRange("scarf.start_height_ratio", speeds.scarf.start_height_ratio, 0, 1));
  status.Update(CheckNoLessThanZero("scarf.length_mm", speeds.scarf.length_mm));
  status.Update(CheckAboveZero("scarf.max_segment_mm", speeds.scarf.max_segment_mm));
  return status;
}

absl::Status CheckCooling(const CoolingOptions& cooling) {
  constexpr std::string_view kFans = "cooling: a fan";
  absl::Status status = CheckRange(kFans, cooling.min_fan_percent, 0, 100);
  status.Update(CheckRange(kFans, cooling.max_fan_percent, 0, 100));
  status.Update(CheckRange(kFans, cooling.bridge_fan_percent, -1, 100));
  for (const int32_t percent : cooling.overhang_fan_percent)
    status.Update(CheckRange(kFans, percent, 0, 100));
  for (const int32_t percent : {cooling.interface_fan_percent, cooling.internal_bridge_fan_percent,
                                cooling.ironing_fan_percent, cooling.first_layer_fan_percent})
    status.Update(CheckRange(kFans, percent, -1, 100));
  status.Update(CheckRange("overhang_fan_share", cooling.overhang_fan_share, 0, 1));
  return status;
}

absl::Status CheckTool(const ToolRow& tool) {
  absl::Status status = CheckAboveZero("nozzle_diameter_mm", tool.nozzle_diameter_mm);
  status.Update(CheckAboveZero("filament_diameter_mm", tool.filament_diameter_mm));
  status.Update(CheckCooling(tool.cooling));
  status.Update(CheckRange("retraction.after_wipe", tool.retraction.after_wipe, 0, 1));
  status.Update(CheckNoLessThanZero("advance.bridges", tool.advance.bridges));
  if (const auto fit = FlowFit::Parse(tool.flow_fit); !fit.ok())
    status.Update(Malformed("flow_fit", std::string(fit.status().message())));
  if (const auto points = ParseAdvancePoints(tool.advance.model); !points.ok())
    status.Update(Malformed("advance.model", std::string(points.status().message())));
  return status;
}

}  // namespace

absl::Status CheckOptions(const SlicingOptions& options) {
  absl::Status status = CheckPositive({{"first_layer_height_nm", options.first_layer_height_nm}});
  status.Update(CheckNotNegative({{"max_gap_nm", options.max_gap_nm},
                                  {"resolution_nm", options.resolution_nm},
                                  {"part_distance_nm", options.part_distance_nm},
                                  {"clearance_radius_nm", options.clearance_radius_nm}}));
  status.Update(CheckRange("max_print_height_nm", static_cast<double>(options.max_print_height_nm),
                           0, limits::kMaxPrintHeight));
  if (!options.bed.empty() && options.bed.size() < 3)
    status.Update(Malformed("bed", "has fewer than 3 points"));
  status.Update(CheckThumbnails(options.thumbnails));
  status.Update(CheckEach(options.objects, "objects", CheckSlicedObject));
  return status;
}

absl::Status CheckOptions(const std::vector<BeadingOptions>& table) {
  return CheckEach(table, "walls", CheckWalls);
}

absl::Status CheckOptions(const std::vector<InfillOptions>& table) {
  return CheckEach(table, "infill", CheckInfill);
}

absl::Status CheckOptions(const OrderingOptions& options) {
  absl::Status status = CheckRows(options.walls.size(), "walls");
  status.Update(CheckNoLessThanZero("improvement_moves", options.improvement_moves));
  for (const double length : {options.travel.longest_hidden_mm, options.travel.max_detour_mm,
                              options.travel.max_detour_ratio})
    status.Update(CheckNoLessThanZero("travel", length));
  return status;
}

absl::Status CheckOptions(const MotionOptions& options) {
  absl::Status status = CheckEach(options.tools, "tools", CheckTool);
  status.Update(CheckEach(options.speeds, "speeds", CheckSpeeds));
  status.Update(CheckRange("max_print_height_nm", static_cast<double>(options.max_print_height_nm),
                           0, limits::kMaxPrintHeight));
  status.Update(CheckNotNegative({{"resolution_nm", options.resolution_nm}}));
  return status;
}

absl::Status CheckOptions(const FdmSettings& settings) {
  PlanningOptions planning{settings.machine.plan, settings.objects, {}};
  absl::Status status = CheckOptions(planning);
  status.Update(CheckRows(settings.tools.size(), "tools"));
  if (status.ok()) status = CheckOptions(MotionOf(settings));
  status.Update(CheckOptions(BeadingOf(settings)));
  status.Update(CheckOptions(InfillOf(settings)));
  status.Update(CheckOptions(OrderingOf(settings)));
  return status;
}

absl::Status CheckOptions(const MillSettings& settings) {
  return CheckNoLessThanZero("output_step", settings.output_step);
}

}  // namespace slicefarm
