#include "processes/fdm/settings/needs.h"

#include <fmt/core.h>

#include <span>

#include "common/base/text.h"
#include "common/config/table/settings_table.h"

namespace slicefarm::config {
namespace {

/// Settings that do nothing unless `met`.
struct Need {
  std::string_view keys;  // by spaces
  std::string_view what;
  bool (*met)(const JobSettings&);
};

constexpr Need kNeeds[] = {
    {"retract_lift retract_speed deretract_speed retract_restart_extra retract_before_travel "
     "filament_retract_lift filament_retract_speed filament_deretract_speed "
     "filament_retract_restart_extra filament_retract_before_travel wipe filament_wipe",
     "retract_length of more than 0",
     [](const JobSettings& s) { return s.motion.retraction.length_mm > 0; }},
    {"retract_lift filament_retract_lift", "travel_ramping_lift = 0",
     [](const JobSettings& s) { return !s.motion.retraction.ramping; }},
    {"travel_max_lift travel_slope travel_lift_before_obstacle filament_travel_max_lift "
     "filament_travel_slope filament_travel_lift_before_obstacle",
     "travel_ramping_lift = 1", [](const JobSettings& s) { return s.motion.retraction.ramping; }},
    {"retract_restart_extra filament_retract_restart_extra",
     "use_firmware_retraction = 0, as the machine pushes what it is set to",
     [](const JobSettings& s) { return !s.motion.writing.firmware_retraction; }},
    {"custom_gcode_per_print_z", "complete_objects = 0",
     [](const JobSettings& s) { return !s.planning.sequence.complete_objects; }},
    {"retract_lift_above retract_lift_below filament_retract_lift_above "
     "filament_retract_lift_below",
     "retract_lift or, with travel_ramping_lift = 1, travel_max_lift of more than 0",
     [](const JobSettings& s) {
       const RetractionOptions& retraction = s.motion.retraction;
       return (retraction.ramping ? retraction.ramp_lift_mm : retraction.lift_mm) > 0;
     }},
    {"travel_short_distance_acceleration", "travel_acceleration of more than 0",
     [](const JobSettings& s) { return s.motion.travel_acceleration_mm_s2 > 0; }},
    {"cooling_perimeter_transition_distance", "cooling_slowdown_logic = consistent_surface",
     [](const JobSettings& s) { return s.motion.cooling.consistent_surface; }},
    {"fuzzy_skin_thickness fuzzy_skin_point_dist", "a fuzzy_skin other than none",
     [](const JobSettings& s) { return s.beading[0].fuzzy != FuzzySkin::kNone; }},
    {"retract_before_wipe filament_retract_before_wipe", "wipe = 1",
     [](const JobSettings& s) { return s.motion.retraction.wipe; }},
    // Accelerations are either all told to the firmware or all left to it.
    {"perimeter_acceleration external_perimeter_acceleration infill_acceleration "
     "solid_infill_acceleration top_solid_infill_acceleration bridge_acceleration "
     "first_layer_acceleration travel_acceleration",
     "default_acceleration of more than 0",
     [](const JobSettings& s) { return s.motion.default_acceleration_mm_s2 > 0; }},
    {"square_corner_velocity minimum_cruise_ratio", "gcode_flavor = klipper",
     [](const JobSettings& s) { return s.motion.flavor == GcodeFlavor::kKlipper; }},
    {"machine_max_jerk_x machine_max_jerk_y machine_max_jerk_z machine_max_jerk_e "
     "machine_max_junction_deviation",
     "a gcode_flavor of Marlin",
     [](const JobSettings& s) { return s.motion.flavor != GcodeFlavor::kKlipper; }},
    // The fan at its least and at bridges runs without.
    {"max_fan_speed fan_below_layer_time slowdown_below_layer_time min_print_speed", "cooling = 1",
     [](const JobSettings& s) { return s.motion.cooling.enabled; }},
    {"skirt_distance skirt_height min_skirt_length draft_shield", "skirts of more than 0",
     [](const JobSettings& s) { return s.planning.skirt.loops > 0; }},
    {"brim_width", "a brim_type other than auto_brim",
     [](const JobSettings& s) { return !s.planning.objects[0].brim.automatic.on; }},
    {"brim_width brim_separation", "a brim_type other than no_brim, and no raft",
     [](const JobSettings& s) {
       const ObjectPlanOptions& object = s.planning.objects[0];
       return object.brim.type != BrimType::kNone && object.raft.heights.layers == 0;
     }},
    {"brim_ears_max_angle brim_ears_detection_length", "brim_type = brim_ears",
     [](const JobSettings& s) { return s.planning.objects[0].brim.type == BrimType::kEars; }},
    {"avoid_crossing_perimeters_max_detour", "avoid_crossing_perimeters = 1",
     [](const JobSettings& s) { return s.ordering.travel.avoid_crossing; }},
    {"retract_inside_after retract_layer_change", "only_retract_when_crossing_perimeters = 1",
     [](const JobSettings& s) { return s.ordering.travel.hide; }},
    {"raft_contact_distance raft_expansion raft_first_layer_expansion raft_first_layer_density "
     "support_material_spacing support_material_angle",
     "raft_layers of more than 0",
     [](const JobSettings& s) { return s.planning.objects[0].raft.heights.layers > 0; }},
    {"min_fan_speed", "cooling = 1 or fan_always_on = 1",
     [](const JobSettings& s) {
       return s.motion.cooling.enabled || s.motion.cooling.fan_always_on;
     }},
    {"extruder_clearance_radius extruder_clearance_height between_objects_gcode",
     "complete_objects = 1",
     [](const JobSettings& s) { return s.planning.sequence.complete_objects; }},
    {"ironing_type ironing_flowrate ironing_spacing ironing_speed", "ironing = 1",
     [](const JobSettings& s) { return s.infill[0].ironing.enabled; }},
    {"small_area_infill_flow_compensation_model", "small_area_infill_flow_compensation = 1",
     [](const JobSettings& s) { return s.infill[0].small_area_flow; }},
    {"infill_smoothing", "fill_pattern = medialaxis",
     [](const JobSettings& s) {
       return !s.infill[0].choose_pattern && s.infill[0].pattern == FillPattern::kMedialAxis;
     }},
    {"infill_goal", "fill_pattern = auto",
     [](const JobSettings& s) { return s.infill[0].choose_pattern; }},
    {"fill_density", "no density_field, which takes its place",
     [](const JobSettings& s) { return s.infill[0].density_field.empty(); }},
    {"fill_pattern", "no stress_field, whose streamlines take its place",
     [](const JobSettings& s) { return s.infill[0].stress_field.empty(); }},
};

/// Settings that do nothing unless a flag that is no option of a stage is so.
struct FlagNeed {
  std::string_view key;
  std::string_view flag;
  bool on;
};

constexpr FlagNeed kFlagNeeds[] = {
    {"automatic_infill_combination_max_layer_height", "automatic_infill_combination", true},
    {"infill_every_layers", "automatic_infill_combination", false},
};

bool IsRings(const JobSettings& s) {
  const ScanStrategy strategy = s.exposure.regions[0].strategy;
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}
bool IsHatched(const JobSettings& s) { return !IsRings(s); }
bool IsLaserGcode(const JobSettings& s) {
  const OutputFormat format = s.exposure.output.format;
  return format == OutputFormat::kGrbl || format == OutputFormat::kMarlin;
}
bool IsCli(const JobSettings& s) {
  const OutputFormat format = s.exposure.output.format;
  return format == OutputFormat::kCliAscii || format == OutputFormat::kCliBinary;
}
bool HasContours(const JobSettings& s) { return s.exposure.regions[0].contours > 0; }

/// What a file cannot say has an effect on the report alone: its times and energies.
constexpr Need kLaserNeeds[] = {
    {"decompose_method ring_overlap link_rings ring_corners",
     "scan_strategy = rings or rings_inward", IsRings},
    {"hatch_angle hatch_rotation alternate_hatch skywriting",
     "scan_strategy = stripes, islands or hatch", IsHatched},
    {"stripe_width", "scan_strategy = stripes",
     [](const JobSettings& s) { return s.exposure.regions[0].strategy == ScanStrategy::kStripes; }},
    {"island_width", "scan_strategy = islands",
     [](const JobSettings& s) { return s.exposure.regions[0].strategy == ScanStrategy::kIslands; }},
    {"scan_overlap", "scan_strategy = stripes or islands",
     [](const JobSettings& s) {
       const ScanStrategy strategy = s.exposure.regions[0].strategy;
       return strategy == ScanStrategy::kStripes || strategy == ScanStrategy::kIslands;
     }},
    {"hatch_offset", "scan_strategy = stripes, islands or hatch, and contours of more than 0",
     [](const JobSettings& s) { return HasContours(s) && !IsRings(s); }},
    {"contours_first contour_power contour_speed contour_focus contour_frequency "
     "contour_point_distance contour_point_time contour_point_delay",
     "contours of more than 0", HasContours},
    {"contour_distance", "contours of more than 1, or of 1 and rings",
     [](const JobSettings& s) { return s.exposure.regions[0].contours > (IsRings(s) ? 0 : 1); }},
    {"skin_overlap", "upskin_layers or downskin_layers of more than 0",
     [](const JobSettings& s) { return s.exposure.regions[0].Halo() > 0; }},
    {"upskin_power upskin_speed upskin_focus upskin_frequency upskin_point_distance "
     "upskin_point_time upskin_point_delay",
     "upskin_layers of more than 0",
     [](const JobSettings& s) { return s.exposure.regions[0].upskin_layers > 0; }},
    {"downskin_power downskin_speed downskin_focus downskin_frequency downskin_point_distance "
     "downskin_point_time downskin_point_delay",
     "downskin_layers of more than 0",
     [](const JobSettings& s) { return s.exposure.regions[0].downskin_layers > 0; }},
    {"thin_wall_power thin_wall_speed thin_wall_focus thin_wall_frequency "
     "thin_wall_point_distance thin_wall_point_time thin_wall_point_delay",
     "thin_wall_exposure = 1",
     [](const JobSettings& s) { return s.exposure.regions[0].thin_walls; }},
    {"contour_frequency hatch_frequency upskin_frequency downskin_frequency thin_wall_frequency "
     "contour_point_distance hatch_point_distance upskin_point_distance downskin_point_distance "
     "thin_wall_point_distance contour_point_time hatch_point_time upskin_point_time "
     "downskin_point_time thin_wall_point_time contour_point_delay hatch_point_delay "
     "upskin_point_delay downskin_point_delay thin_wall_point_delay",
     "output_format = cli or cli_binary, or only the report heeds it", IsCli},
    {"contour_focus hatch_focus upskin_focus downskin_focus thin_wall_focus contour_power "
     "hatch_power upskin_power downskin_power thin_wall_power contour_speed hatch_speed "
     "upskin_speed downskin_speed thin_wall_speed",
     "output_format = cli, cli_binary, grbl or marlin, or only the report heeds it",
     [](const JobSettings& s) { return IsCli(s) || IsLaserGcode(s); }},
    {"jump_delay mark_delay polygon_delay",
     "output_format = grbl or marlin, or only the report heeds it", IsLaserGcode},
    {"jump_speed", "output_format = marlin, or only the report heeds it",
     [](const JobSettings& s) { return s.exposure.output.format == OutputFormat::kMarlin; }},
    {"laser_spot", "output_format = svg, or rings with ring_corners = 1",
     [](const JobSettings& s) {
       return s.exposure.output.format == OutputFormat::kSvg ||
              (IsRings(s) && s.exposure.regions[0].fill_corners);
     }},
    {"output_layer", "output_format = dxf",
     [](const JobSettings& s) { return s.exposure.output.format == OutputFormat::kDxf; }},
    {"cli_unit", "output_format = cli or cli_binary", IsCli},
    {"laser_full_power laser_full_s laser_dynamic_power", "output_format = grbl or marlin",
     IsLaserGcode},
};

std::span<const Need> NeedsOf(Process process) {
  if (process == Process::kLaser) return kLaserNeeds;
  return kNeeds;
}

/// Whether somebody wants it, rather than a profile listing it.
bool IsWanted(const Draft& draft, std::string_view key) {
  const Draft::Entry& entry = draft.At(key);
  if (!entry.given || !entry.value.has_value()) return false;
  const int index = FindSetting(key, draft.process());
  return entry.requested || !IsStandard(SettingsTable(draft.process())[index], entry.written);
}

}  // namespace

std::vector<std::string> UnmetNeeds(const Draft& draft, const JobSettings& settings) {
  std::vector<std::string> notes;
  for (const Need& need : NeedsOf(draft.process())) {
    if (need.met(settings)) continue;
    for (const std::string_view key : Split(need.keys, " ")) {
      if (IsWanted(draft, key))
        notes.push_back(fmt::format("{} = {}: needs {}", key, draft.At(key).written, need.what));
    }
  }
  if (draft.process() != Process::kFdm) return notes;
  for (const FlagNeed& need : kFlagNeeds)
    if ((draft.Number(need.flag) != 0) != need.on && IsWanted(draft, need.key))
      notes.push_back(fmt::format("{} = {}: needs {} = {}", need.key, draft.At(need.key).written,
                                  need.flag, need.on ? 1 : 0));
  return notes;
}

}  // namespace slicefarm::config
