#include "processes/fdm/settings/needs.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "common/model/options/tool_row.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm {
namespace {

bool HasSupports(const JobRows& s) { return FdmOf(s).object.support.on; }

bool Combines(const SettingValues& draft) {
  return draft.Number("automatic_infill_combination") != 0;
}

constexpr std::string_view kNoProfile = "no layer_height_profile, which replaces it";

constexpr Need kNeeds[] = {
    {"retract_lift retract_speed deretract_speed retract_restart_extra retract_before_travel "
     "filament_retract_lift filament_retract_speed filament_deretract_speed "
     "filament_retract_restart_extra filament_retract_before_travel wipe filament_wipe",
     "retract_length above 0",
     [](const JobRows& s) { return FdmOf(s).tool.retraction.length_mm > 0; }},
    {"retract_lift filament_retract_lift", "travel_ramping_lift = 0",
     [](const JobRows& s) { return !FdmOf(s).tool.retraction.ramping; }},
    {"travel_max_lift travel_slope travel_lift_before_obstacle filament_travel_max_lift "
     "filament_travel_slope filament_travel_lift_before_obstacle",
     "travel_ramping_lift = 1", [](const JobRows& s) { return FdmOf(s).tool.retraction.ramping; }},
    {"retract_restart_extra filament_retract_restart_extra",
     "use_firmware_retraction = 0, because the firmware sets this length itself",
     [](const JobRows& s) { return !FdmOf(s).machine.motion.writing.firmware_retraction; }},
    {"adaptive_layer_cusp adaptive_layer_ratio", "adaptive_layer_height = 1",
     [](const JobRows& s) { return s.object.adaptive.on; }},
    {"adaptive_layer_height adaptive_layer_cusp adaptive_layer_ratio", kNoProfile,
     [](const JobRows& s) {
       const ObjectSlicingOptions& object = s.object;
       return !object.adaptive.on || object.height_profile.empty();
     }},
    {"custom_gcode_per_print_z", "complete_objects = 0",
     [](const JobRows& s) { return !FdmOf(s).machine.plan.sequence.complete_objects; }},
    {"retract_lift_above retract_lift_below filament_retract_lift_above "
     "filament_retract_lift_below",
     "retract_lift above 0 or, with travel_ramping_lift = 1, travel_max_lift above 0",
     [](const JobRows& s) {
       const RetractionOptions& retraction = FdmOf(s).tool.retraction;
       return (retraction.ramping ? retraction.ramp_lift_mm : retraction.lift_mm) > 0;
     }},
    {"travel_short_distance_acceleration", "travel_acceleration above 0",
     [](const JobRows& s) { return FdmOf(s).machine.motion.travel_acceleration_mm_s2 > 0; }},
    {"cooling_perimeter_transition_distance", "cooling_slowdown_logic = consistent_surface",
     [](const JobRows& s) { return FdmOf(s).tool.cooling.consistent_surface; }},
    {"fuzzy_skin_thickness fuzzy_skin_point_dist", "a fuzzy_skin other than none",
     [](const JobRows& s) { return FdmOf(s).region.walls.fuzzy != FuzzySkin::kNone; }},
    {"retract_before_wipe filament_retract_before_wipe wipe_distance filament_wipe_distance "
     "wipe_speed role_based_wipe_speed",
     "wipe = 1", [](const JobRows& s) { return FdmOf(s).tool.retraction.wipe; }},
    {"wipe_speed", "role_based_wipe_speed = 0",
     [](const JobRows& s) { return !FdmOf(s).machine.motion.wipe_as_printed; }},
    // slicefarm either sends all accelerations to the firmware or none.
    {"perimeter_acceleration external_perimeter_acceleration infill_acceleration "
     "solid_infill_acceleration top_solid_infill_acceleration bridge_acceleration "
     "first_layer_acceleration travel_acceleration",
     "default_acceleration above 0",
     [](const JobRows& s) { return FdmOf(s).machine.motion.default_acceleration_mm_s2 > 0; }},
    {"square_corner_velocity minimum_cruise_ratio", "gcode_flavor = klipper",
     [](const JobRows& s) { return FdmOf(s).machine.motion.flavor == GcodeFlavor::kKlipper; }},
    {"machine_max_jerk_x machine_max_jerk_y machine_max_jerk_z machine_max_jerk_e "
     "machine_max_junction_deviation",
     "a gcode_flavor of Marlin",
     [](const JobRows& s) { return FdmOf(s).machine.motion.flavor != GcodeFlavor::kKlipper; }},
    // The minimum fan speed and the bridge fan speed have an effect without cooling.
    {"max_fan_speed fan_below_layer_time slowdown_below_layer_time min_print_speed", "cooling = 1",
     [](const JobRows& s) { return FdmOf(s).tool.cooling.enabled; }},
    {"skirt_distance skirt_height min_skirt_length draft_shield", "skirts above 0",
     [](const JobRows& s) { return FdmOf(s).machine.plan.skirt.loops > 0; }},
    {"brim_width", "a brim_type other than auto_brim",
     [](const JobRows& s) { return !FdmOf(s).object.brim.automatic.on; }},
    {"brim_width brim_separation", "a brim_type other than no_brim, and no raft",
     [](const JobRows& s) {
       const ObjectPlanOptions& object = FdmOf(s).object;
       return object.brim.type != BrimType::kNone && object.raft.heights.layers == 0;
     }},
    {"brim_ears_max_angle brim_ears_detection_length", "brim_type = brim_ears",
     [](const JobRows& s) { return FdmOf(s).object.brim.type == BrimType::kEars; }},
    {"avoid_crossing_perimeters_max_detour", "avoid_crossing_perimeters = 1",
     [](const JobRows& s) { return FdmOf(s).machine.order.travel.avoid_crossing; }},
    {"retract_inside_after retract_layer_change", "only_retract_when_crossing_perimeters = 1",
     [](const JobRows& s) { return FdmOf(s).machine.order.travel.hide; }},
    {"raft_contact_distance raft_expansion", "raft_layers above 0",
     [](const JobRows& s) { return FdmOf(s).object.raft.heights.layers > 0; }},
    {"raft_first_layer_expansion",
     "raft_layers above 0, or support_material = 1 with support_material_style = organic",
     [](const JobRows& s) {
       const ObjectPlanOptions& object = FdmOf(s).object;
       return object.raft.heights.layers > 0 ||
              (object.support.on && object.support.style == SupportStyle::kTree);
     }},
    {"raft_first_layer_density support_material_spacing support_material_angle "
     "support_material_interface_spacing",
     "raft_layers above 0 or support_material = 1",
     [](const JobRows& s) {
       const ObjectPlanOptions& object = FdmOf(s).object;
       return object.raft.heights.layers > 0 || object.support.on;
     }},
    {"dont_support_bridges support_material_auto "
     "support_material_buildplate_only "
     "support_material_closing_radius support_material_contact_distance "
     "support_material_enforce_layers support_material_interface_layers "
     "support_material_interface_pattern support_material_pattern support_material_style "
     "support_material_synchronize_layers support_material_threshold "
     "support_material_with_sheath",
     "support_material = 1", HasSupports},
    {.keys = "support_material_bottom_contact_distance support_material_bottom_interface_layers "
             "support_material_xy_spacing",
     .what = "support_material = 1",
     .met = HasSupports,
     .only_requested = true},
    {"support_tree_angle support_tree_angle_slow support_tree_branch_diameter "
     "support_tree_branch_diameter_angle support_tree_branch_diameter_double_wall "
     "support_tree_branch_distance support_tree_tip_diameter support_tree_top_rate",
     "support_material = 1 and support_material_style = organic",
     [](const JobRows& s) {
       const SupportOptions& support = FdmOf(s).object.support;
       return support.on && support.style == SupportStyle::kTree;
     }},
    {"min_fan_speed", "cooling = 1 or fan_always_on = 1",
     [](const JobRows& s) {
       return FdmOf(s).tool.cooling.enabled || FdmOf(s).tool.cooling.fan_always_on;
     }},
    {"extruder_clearance_radius extruder_clearance_height extruder_clearance_height_to_lid "
     "extruder_clearance_dist_to_rod nozzle_height between_objects_gcode",
     "complete_objects = 1",
     [](const JobRows& s) { return FdmOf(s).machine.plan.sequence.complete_objects; }},
    {"ironing_type ironing_flowrate ironing_spacing ironing_inset ironing_speed", "ironing = 1",
     [](const JobRows& s) { return FdmOf(s).region.infill.ironing.enabled; }},
    {"small_area_infill_flow_compensation_model", "small_area_infill_flow_compensation = 1",
     [](const JobRows& s) { return FdmOf(s).region.infill.small_area_flow; }},
    {"infill_smoothing", "fill_pattern = medialaxis",
     [](const JobRows& s) {
       return !FdmOf(s).region.infill.choose_pattern &&
              FdmOf(s).region.infill.pattern == FillPattern::kMedialAxis;
     }},
    {"infill_goal", "fill_pattern = auto",
     [](const JobRows& s) { return FdmOf(s).region.infill.choose_pattern; }},
    {"fill_density", "no density_field, which replaces it",
     [](const JobRows& s) { return FdmOf(s).region.infill.density_field.empty(); }},
    {"fill_pattern", "no stress_field, which replaces it",
     [](const JobRows& s) { return FdmOf(s).region.infill.stress_field.empty(); }},
    {"automatic_infill_combination_max_layer_height", "automatic_infill_combination = 1", nullptr,
     Combines},
    {"infill_every_layers", "automatic_infill_combination = 0", nullptr,
     [](const SettingValues& draft) { return !Combines(draft); }},
};

}  // namespace

std::vector<std::string> NeedsOfObject(const SceneObject& object, const JobRows& settings) {
  std::vector<std::string> unmet;
  const bool enforced =
      std::ranges::count(object.parts, PartRole::kSupportEnforcer, &Part::role) > 0;
  if (enforced && !HasSupports(settings))
    unmet.push_back("support enforcers, painted or as parts: needs support_material = 1");
  if (settings.object.height_profile.empty()) return unmet;
  for (const HeightRange& range : object.ranges)
    for (const Setting& setting : range.settings)
      if (setting.key == "layer_height")
        unmet.push_back(fmt::format("layer_height = {} from {} to {} mm: needs {}", setting.value,
                                    range.from_mm, range.to_mm, kNoProfile));
  return unmet;
}

std::vector<Need> Needs() { return {std::begin(kNeeds), std::end(kNeeds)}; }

}  // namespace slicefarm::config::fdm
