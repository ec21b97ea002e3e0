#include "common/config/needs.h"

#include <fmt/core.h>

#include <span>

#include "common/config/settings_table.h"
#include "common/base/text.h"

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
     "filament_retract_restart_extra filament_retract_before_travel",
     "retract_length of more than 0",
     [](const JobSettings& s) { return s.motion.retraction.length_mm > 0; }},
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
    {"brim_width brim_separation", "a brim_type other than no_brim, and no raft",
     [](const JobSettings& s) {
       const ObjectPlanOptions& object = s.planning.objects[0];
       return object.brim.type != BrimType::kNone && object.raft.heights.layers == 0;
     }},
    {"brim_ears_max_angle brim_ears_detection_length", "brim_type = brim_ears",
     [](const JobSettings& s) { return s.planning.objects[0].brim.type == BrimType::kEars; }},
    {"avoid_crossing_perimeters_max_detour", "avoid_crossing_perimeters = 1",
     [](const JobSettings& s) { return s.ordering.travel.avoid_crossing; }},
    {"retract_inside_after", "only_retract_when_crossing_perimeters = 1",
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
    {"infill_goal", "fill_pattern = auto",
     [](const JobSettings& s) { return s.infill[0].choose_pattern; }},
    {"fill_density", "no density_field, which takes its place",
     [](const JobSettings& s) { return s.infill[0].density_field.empty(); }},
    {"fill_pattern", "no stress_field, whose streamlines take its place",
     [](const JobSettings& s) { return s.infill[0].stress_field.empty(); }},
};

constexpr Need kLaserNeeds[] = {
    {"decompose_method ring_overlap link_rings", "scan_strategy = rings or rings_inward",
     [](const JobSettings& s) {
       const ScanStrategy strategy = s.exposure.regions[0].strategy;
       return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
     }},
    {"stripe_width", "scan_strategy = stripes",
     [](const JobSettings& s) {
       return s.exposure.regions[0].strategy == ScanStrategy::kStripes;
     }},
    {"island_width", "scan_strategy = islands",
     [](const JobSettings& s) {
       return s.exposure.regions[0].strategy == ScanStrategy::kIslands;
     }},
    {"scan_overlap", "scan_strategy = stripes or islands",
     [](const JobSettings& s) {
       const ScanStrategy strategy = s.exposure.regions[0].strategy;
       return strategy == ScanStrategy::kStripes || strategy == ScanStrategy::kIslands;
     }},
    {"output_layer", "output_format = dxf",
     [](const JobSettings& s) { return s.exposure.output.format == OutputFormat::kDxf; }},
    {"cli_unit", "output_format = cli or cli_binary",
     [](const JobSettings& s) {
       const OutputFormat format = s.exposure.output.format;
       return format == OutputFormat::kCliAscii || format == OutputFormat::kCliBinary;
     }},
    {"laser_full_power laser_full_s", "output_format = grbl or marlin",
     [](const JobSettings& s) {
       const OutputFormat format = s.exposure.output.format;
       return format == OutputFormat::kGrbl || format == OutputFormat::kMarlin;
     }},
    {"laser_dynamic_power", "output_format = grbl",
     [](const JobSettings& s) { return s.exposure.output.format == OutputFormat::kGrbl; }},
};

std::span<const Need> NeedsOf(Process process) {
  if (process == Process::kLaser) return kLaserNeeds;
  return kNeeds;
}

/// Whether somebody wants it, rather than a profile listing it.
bool Wanted(const SettingSpec& spec, const Draft::Entry& entry) {
  if (!entry.given || !entry.value.has_value()) return false;
  return entry.requested || !IsStandard(spec, entry.written);
}

}  // namespace

std::vector<std::string> UnmetNeeds(const Draft& draft, const JobSettings& settings) {
  std::vector<std::string> notes;
  for (const Need& need : NeedsOf(draft.process())) {
    if (need.met(settings)) continue;
    for (const std::string_view key : Split(need.keys, " ")) {
      const int index = FindSetting(key, draft.process());
      const Draft::Entry& entry = draft.At(key);
      if (!Wanted(SettingsTable(draft.process())[index], entry)) continue;
      notes.push_back(fmt::format("{} = {}: needs {}", key, entry.written, need.what));
    }
  }
  return notes;
}

}  // namespace slicefarm::config
