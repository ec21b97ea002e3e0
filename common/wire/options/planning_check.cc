#include <numbers>
#include <string_view>

#include "common/model/options/adhesion_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "common/wire/options/options_check.h"
#include "common/wire/options/value_checks.h"

namespace slicefarm {
namespace {

absl::Status CheckRow(std::string_view member, int32_t row) {
  if (0 <= row && row < limits::kMaxRegionSettings) return absl::OkStatus();
  return Malformed(member, "is no row of a table of region settings");
}

absl::Status CheckSkirt(const SkirtOptions& skirt) {
  absl::Status status = CheckRange("skirt.loops", skirt.loops, 0, limits::kMaxSkirtLoops);
  status.Update(CheckRange("skirt.height_layers", skirt.height_layers, 0, limits::kMaxLayers));
  status.Update(CheckNotNegative({{"skirt.distance_nm", skirt.distance_nm}}));
  status.Update(
      CheckPositive({{"skirt.width_nm", skirt.width_nm}, {"skirt.height_nm", skirt.height_nm}}));
  status.Update(
      CheckNoLessThanZero("skirt.min_length_nm", static_cast<double>(skirt.min_length_nm)));
  status.Update(CheckAboveZero("skirt.filament_area_mm2", skirt.filament_area_mm2));
  return status;
}

absl::Status CheckBrim(const BrimOptions& brim) {
  absl::Status status = CheckNotNegative({{"brim.width_nm", brim.width_nm},
                                          {"brim.separation_nm", brim.separation_nm},
                                          {"brim.ear_detection_nm", brim.ear_detection_nm}});
  status.Update(CheckPositive({{"brim.line_width_nm", brim.line_width_nm}}));
  if (!(0 <= brim.ear_max_angle_rad && brim.ear_max_angle_rad < 2 * std::numbers::pi))
    status.Update(Malformed("brim.ear_max_angle_rad", "is out of range"));
  const AutomaticBrim& automatic = brim.automatic;
  status.Update(CheckAboveZero("brim.automatic.thermal_length_mm", automatic.thermal_length_mm));
  status.Update(CheckNoLessThanZero("brim.automatic.adhesion", automatic.adhesion));
  status.Update(CheckNoLessThanZero("brim.automatic.max_speed_mm_s", automatic.max_speed_mm_s));
  return status;
}

absl::Status CheckRaft(const RaftOptions& raft) {
  absl::Status status = CheckRange("raft.layers", raft.heights.layers, 0, limits::kMaxRaftLayers);
  status.Update(CheckPositive({{"raft.first_nm", raft.heights.first_nm},
                               {"raft.others_nm", raft.heights.others_nm},
                               {"raft.width_nm", raft.lines.width_nm}}));
  status.Update(
      CheckNotNegative({{"raft.contact_distance_nm", raft.heights.contact_distance_nm},
                        {"raft.spacing_nm", raft.lines.spacing_nm},
                        {"raft.expansion_nm", raft.expansion_nm},
                        {"raft.first_layer_expansion_nm", raft.first_layer_expansion_nm}}));
  status.Update(CheckRange("raft.first_layer_density", raft.lines.first_layer_density, 0, 1));
  return status;
}

absl::Status CheckTree(const TreeOptions& tree) {
  absl::Status status = CheckPositive({{"tree.branch_diameter_nm", tree.branch_diameter_nm},
                                       {"tree.tip_diameter_nm", tree.tip_diameter_nm},
                                       {"tree.branch_distance_nm", tree.branch_distance_nm}});
  status.Update(CheckNotNegative({{"tree.double_wall_diameter_nm", tree.double_wall_diameter_nm}}));
  for (const double angle_rad : {tree.angle_rad, tree.slow_angle_rad, tree.diameter_angle_rad})
    if (!(0 <= angle_rad && angle_rad < std::numbers::pi / 2))
      status.Update(Malformed("tree.angle_rad", "is not of a branch"));
  status.Update(CheckRange("tree.top_rate", tree.top_rate, 0, 1));
  return status;
}

absl::Status CheckSupport(const SupportOptions& support) {
  absl::Status status =
      CheckNotNegative({{"support.top_gap_nm", support.top_gap_nm},
                        {"support.bottom_gap_nm", support.bottom_gap_nm},
                        {"support.xy_gap_nm", support.xy_gap_nm},
                        {"support.closing_radius_nm", support.closing_radius_nm},
                        {"support.spacing_nm", support.spacing_nm},
                        {"support.interface_spacing_nm", support.interface_spacing_nm},
                        {"support.walls_nm", support.walls_nm}});
  status.Update(CheckNoLessThanZero("support.ironing.flow", support.ironing.flow));
  status.Update(CheckPositive({{"support.ironing.spacing_nm", support.ironing.spacing_nm},
                               {"support.width_nm", support.width_nm},
                               {"support.wall_width_nm", support.wall_width_nm},
                               {"support.layer_height_nm", support.layer_height_nm},
                               {"support.first_layer_height_nm", support.first_layer_height_nm},
                               {"support.min_layer_height_nm", support.min_layer_height_nm}}));
  for (const int32_t layers :
       {support.enforced_layers, support.top_interface_layers, support.bottom_interface_layers})
    status.Update(CheckRange("support: a count of layers", layers, 0, limits::kMaxLayers));
  status.Update(
      CheckRange("support.threshold_rad", support.threshold_rad, 0, std::numbers::pi / 2));
  status.Update(CheckTree(support.tree));
  return status;
}

absl::Status CheckPlannedObject(const ObjectPlanOptions& object) {
  absl::Status status = CheckRow("brim_settings", object.brim_settings);
  for (const int32_t row : object.raft_settings) status.Update(CheckRow("raft_settings", row));
  for (const int32_t row : object.support_settings)
    status.Update(CheckRow("support_settings", row));
  status.Update(CheckBrim(object.brim));
  status.Update(CheckRaft(object.raft));
  status.Update(CheckSupport(object.support));
  status.Update(CheckNotNegative({{"spiral.width_nm", object.spiral.width_nm}}));
  return status;
}

}  // namespace

absl::Status CheckOptions(const PlanningOptions& options) {
  absl::Status status = CheckEach(options.objects, "objects", CheckPlannedObject);
  if (!options.infill.empty()) status.Update(CheckOptions(options.infill));
  status.Update(
      CheckNotNegative({{"sequence.clearance_radius_nm", options.sequence.clearance_radius_nm},
                        {"sequence.clearance_height_nm", options.sequence.clearance_height_nm},
                        {"sequence.lid_height_nm", options.sequence.lid_height_nm},
                        {"sequence.gantry_reach_nm", options.sequence.gantry_reach_nm},
                        {"sequence.nozzle_height_nm", options.sequence.nozzle_height_nm}}));
  status.Update(CheckRow("skirt_settings", options.skirt_settings));
  status.Update(CheckSkirt(options.skirt));
  return status;
}

}  // namespace slicefarm
