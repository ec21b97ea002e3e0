#include "common/wire/options/motion_options_wire.h"

#include <algorithm>
#include <array>
#include <vector>

#include "common/model/limits.h"
#include "common/wire/geometry_wire.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

using google::protobuf::RepeatedField;

constexpr int kFlavors = 6;
static_assert(v1::GCODE_FLAVOR_MARLIN2 == static_cast<int>(GcodeFlavor::kMarlin2) + 1);
static_assert(v1::GCODE_FLAVOR_MARLIN_LEGACY == static_cast<int>(GcodeFlavor::kMarlinLegacy) + 1);
static_assert(v1::GCODE_FLAVOR_KLIPPER == static_cast<int>(GcodeFlavor::kKlipper) + 1);
static_assert(v1::GCODE_FLAVOR_REPRAP_FIRMWARE ==
              static_cast<int>(GcodeFlavor::kRepRapFirmware) + 1);
static_assert(v1::GCODE_FLAVOR_PRUSA_BUDDY == static_cast<int>(GcodeFlavor::kPrusaBuddy) + 1);
static_assert(v1::GCODE_FLAVOR_BAMBU == static_cast<int>(GcodeFlavor::kBambu) + 1);
static_assert(v1::GcodeFlavor_MAX == kFlavors);
static_assert(v1::ARC_FITTING_DISABLED == static_cast<int>(ArcFitting::kDisabled) + 1);
static_assert(v1::ARC_FITTING_EMIT_CENTER == static_cast<int>(ArcFitting::kEmitCenter) + 1);
static_assert(v1::ArcFitting_MAX == v1::ARC_FITTING_EMIT_CENTER);
static_assert(v1::OBJECT_LABELS_NONE == static_cast<int>(ObjectLabels::kNone) + 1);
static_assert(v1::OBJECT_LABELS_COMMENTS == static_cast<int>(ObjectLabels::kComments) + 1);
static_assert(v1::OBJECT_LABELS_FIRMWARE == static_cast<int>(ObjectLabels::kFirmware) + 1);
static_assert(v1::ObjectLabels_MAX == v1::OBJECT_LABELS_FIRMWARE);

static_assert(v1::LIFT_AFTER_ALL == static_cast<int>(LiftAfter::kAll) + 1);
static_assert(v1::LIFT_AFTER_TOP == static_cast<int>(LiftAfter::kTop) + 1);
static_assert(v1::LIFT_AFTER_BOTTOM == static_cast<int>(LiftAfter::kBottom) + 1);
static_assert(v1::LIFT_AFTER_TOP_AND_BOTTOM == static_cast<int>(LiftAfter::kTopAndBottom) + 1);
static_assert(v1::LiftAfter_MAX == v1::LIFT_AFTER_TOP_AND_BOTTOM);
static_assert(v1::SCARF_PLACEMENT_NOWHERE == static_cast<int>(ScarfPlacement::kNowhere) + 1);
static_assert(v1::SCARF_PLACEMENT_CONTOURS == static_cast<int>(ScarfPlacement::kContours) + 1);
static_assert(v1::SCARF_PLACEMENT_EVERYWHERE == static_cast<int>(ScarfPlacement::kEverywhere) + 1);
static_assert(v1::ScarfPlacement_MAX == v1::SCARF_PLACEMENT_EVERYWHERE);

template <typename Number, size_t N>
void Put(const std::array<Number, N>& values, RepeatedField<Number>* proto) {
  proto->Assign(values.begin(), values.end());
}

/// REQUIRES: CheckSizes.
template <typename Number, size_t N>
void Take(const RepeatedField<Number>& proto, std::array<Number, N>* values) {
  std::ranges::copy(proto, values->begin());
}

absl::Status CheckSizes(const v1::MachineLimits& limits) {
  if (limits.max_feedrate_mm_s_size() != 4) return Malformed("max_feedrate_mm_s", "not 4");
  if (limits.max_acceleration_mm_s2_size() != 4)
    return Malformed("max_acceleration_mm_s2", "not 4");
  if (limits.max_jerk_mm_s_size() != 4) return Malformed("max_jerk_mm_s", "not 4");
  return absl::OkStatus();
}

absl::Status CheckSizes(const v1::MotionOptions& proto) {
  if (absl::Status good = CheckSizes(proto.limits()); !good.ok()) return Within("limits", good);
  if (proto.has_silent_limits())
    if (absl::Status good = CheckSizes(proto.silent_limits()); !good.ok())
      return Within("silent_limits", good);
  if (absl::Status rows = CheckRows(proto.speeds_size(), "speeds"); !rows.ok()) return rows;
  for (const v1::RegionSpeeds& region : proto.speeds()) {
    if (absl::Status complete = CheckComplete(region); !complete.ok()) return complete;
    if (region.speed_mm_s_size() != kFeatureCount)
      return Malformed("speeds.speed_mm_s", "not one for each feature");
    if (region.overhang_speed_mm_s_size() != kOverhangDegrees)
      return Malformed("speeds.overhang_speed_mm_s", "not one for each degree");
  }
  if (proto.cooling().overhang_fan_percent_size() != kOverhangDegrees)
    return Malformed("cooling.overhang_fan_percent", "not one for each degree");
  if (proto.acceleration_mm_s2_size() != kFeatureCount) {
    return Malformed("acceleration_mm_s2", "not one for each feature");
  }
  return absl::OkStatus();
}

absl::Status CheckRanges(const v1::MotionOptions& proto) {
  if (proto.nozzle_diameter_mm() <= 0) return Malformed("nozzle_diameter_mm", "is not positive");
  if (proto.filament_diameter_mm() <= 0) {
    return Malformed("filament_diameter_mm", "is not positive");
  }
  for (const v1::RegionSpeeds& region : proto.speeds()) {
    const auto is_negative = [](double speed) { return !(speed >= 0); };
    if (std::ranges::any_of(region.speed_mm_s(), is_negative))
      return Malformed("speeds.speed_mm_s", "is negative");
    if (std::ranges::any_of(region.overhang_speed_mm_s(), is_negative))
      return Malformed("speeds.overhang_speed_mm_s", "is negative");
    if (!(region.bridge_flow() > 0)) return Malformed("speeds.bridge_flow", "is not above 0");
    const v1::ScarfOptions& scarf = region.scarf();
    if (!(scarf.start_height_ratio() >= 0 && scarf.start_height_ratio() <= 1))
      return Malformed("speeds.scarf.start_height_ratio", "is no share");
    if (!(scarf.length_mm() >= 0)) return Malformed("speeds.scarf.length_mm", "is negative");
    if (!(scarf.max_segment_mm() > 0))
      return Malformed("speeds.scarf.max_segment_mm", "is not positive");
  }
  if (proto.max_print_height_nm() < 0 || proto.max_print_height_nm() > limits::kMaxPrintHeight)
    return Malformed("max_print_height_nm", "is out of range");
  if (proto.resolution_nm() < 0 || proto.resolution_nm() > limits::kMaxCoord)
    return Malformed("resolution_nm", "is out of range");
  const v1::CoolingOptions& cooling = proto.cooling();
  std::vector<int32_t> fans = {cooling.min_fan_percent(), cooling.max_fan_percent(),
                               cooling.bridge_fan_percent()};
  fans.insert(fans.end(), cooling.overhang_fan_percent().begin(),
              cooling.overhang_fan_percent().end());
  if (std::ranges::any_of(fans, [](int32_t percent) { return percent < 0 || percent > 100; }))
    return Malformed("cooling", "not all fans are percentages");
  return absl::OkStatus();
}

v1::MachineLimits ToProto(const MachineLimits& limits) {
  v1::MachineLimits proto;
  Put(limits.max_feedrate_mm_s, proto.mutable_max_feedrate_mm_s());
  Put(limits.max_acceleration_mm_s2, proto.mutable_max_acceleration_mm_s2());
  Put(limits.max_jerk_mm_s, proto.mutable_max_jerk_mm_s());
  proto.set_max_acceleration_extruding_mm_s2(limits.max_acceleration_extruding_mm_s2);
  proto.set_max_acceleration_retracting_mm_s2(limits.max_acceleration_retracting_mm_s2);
  proto.set_max_acceleration_travel_mm_s2(limits.max_acceleration_travel_mm_s2);
  proto.set_junction_deviation_mm(limits.junction_deviation_mm);
  proto.set_square_corner_velocity_mm_s(limits.square_corner_velocity_mm_s);
  proto.set_minimum_cruise_ratio(limits.minimum_cruise_ratio);
  proto.set_min_extruding_rate_mm_s(limits.min_extruding_rate_mm_s);
  proto.set_min_travel_rate_mm_s(limits.min_travel_rate_mm_s);
  proto.set_jerk_mm_s3(limits.jerk_mm_s3);
  proto.set_emit_to_gcode(limits.emit_to_gcode);
  return proto;
}

MachineLimits FromProto(const v1::MachineLimits& proto) {
  MachineLimits limits;
  Take(proto.max_feedrate_mm_s(), &limits.max_feedrate_mm_s);
  Take(proto.max_acceleration_mm_s2(), &limits.max_acceleration_mm_s2);
  Take(proto.max_jerk_mm_s(), &limits.max_jerk_mm_s);
  limits.max_acceleration_extruding_mm_s2 = proto.max_acceleration_extruding_mm_s2();
  limits.max_acceleration_retracting_mm_s2 = proto.max_acceleration_retracting_mm_s2();
  limits.max_acceleration_travel_mm_s2 = proto.max_acceleration_travel_mm_s2();
  limits.junction_deviation_mm = proto.junction_deviation_mm();
  limits.square_corner_velocity_mm_s = proto.square_corner_velocity_mm_s();
  limits.minimum_cruise_ratio = proto.minimum_cruise_ratio();
  limits.min_extruding_rate_mm_s = proto.min_extruding_rate_mm_s();
  limits.min_travel_rate_mm_s = proto.min_travel_rate_mm_s();
  limits.jerk_mm_s3 = proto.jerk_mm_s3();
  limits.emit_to_gcode = proto.emit_to_gcode();
  return limits;
}

v1::RetractionOptions ToProto(const RetractionOptions& retraction) {
  v1::RetractionOptions proto;
  proto.set_length_mm(retraction.length_mm);
  proto.set_speed_mm_s(retraction.speed_mm_s);
  proto.set_restart_speed_mm_s(retraction.restart_speed_mm_s);
  proto.set_restart_extra_mm(retraction.restart_extra_mm);
  proto.set_min_travel_mm(retraction.min_travel_mm);
  proto.set_lift_mm(retraction.lift_mm);
  proto.set_lift_above_mm(retraction.lift_above_mm);
  proto.set_lift_below_mm(retraction.lift_below_mm);
  proto.set_ramping(retraction.ramping);
  proto.set_ramp_lift_mm(retraction.ramp_lift_mm);
  proto.set_ramp_slope_deg(retraction.ramp_slope_deg);
  proto.set_before_obstacles(retraction.before_obstacles);
  proto.set_lift_after(EnumToProto<v1::LiftAfter>(retraction.lift_after));
  proto.set_wipe(retraction.wipe);
  proto.set_before_wipe(retraction.before_wipe);
  return proto;
}

RetractionOptions FromProto(const v1::RetractionOptions& proto) {
  RetractionOptions retraction;
  retraction.length_mm = proto.length_mm();
  retraction.speed_mm_s = proto.speed_mm_s();
  retraction.restart_speed_mm_s = proto.restart_speed_mm_s();
  retraction.restart_extra_mm = proto.restart_extra_mm();
  retraction.min_travel_mm = proto.min_travel_mm();
  retraction.lift_mm = proto.lift_mm();
  retraction.lift_above_mm = proto.lift_above_mm();
  retraction.lift_below_mm = proto.lift_below_mm();
  retraction.ramping = proto.ramping();
  retraction.ramp_lift_mm = proto.ramp_lift_mm();
  retraction.ramp_slope_deg = proto.ramp_slope_deg();
  retraction.before_obstacles = proto.before_obstacles();
  retraction.lift_after = Known<LiftAfter>(proto.lift_after());
  retraction.wipe = proto.wipe();
  retraction.before_wipe = proto.before_wipe();
  return retraction;
}

v1::CoolingOptions ToProto(const CoolingOptions& cooling) {
  v1::CoolingOptions proto;
  proto.set_enabled(cooling.enabled);
  proto.set_fan_always_on(cooling.fan_always_on);
  proto.set_min_fan_percent(cooling.min_fan_percent);
  proto.set_max_fan_percent(cooling.max_fan_percent);
  proto.set_bridge_fan_percent(cooling.bridge_fan_percent);
  proto.set_disable_fan_first_layers(cooling.disable_fan_first_layers);
  proto.set_fan_below_layer_time_s(cooling.fan_below_layer_time_s);
  proto.set_slowdown_below_layer_time_s(cooling.slowdown_below_layer_time_s);
  proto.set_min_print_speed_mm_s(cooling.min_print_speed_mm_s);
  proto.set_consistent_surface(cooling.consistent_surface);
  proto.set_transition_mm(cooling.transition_mm);
  proto.set_full_fan_speed_layer(cooling.full_fan_speed_layer);
  proto.set_dynamic_fan(cooling.dynamic_fan);
  Put(cooling.overhang_fan_percent, proto.mutable_overhang_fan_percent());
  return proto;
}

CoolingOptions FromProto(const v1::CoolingOptions& proto) {
  CoolingOptions cooling;
  cooling.enabled = proto.enabled();
  cooling.fan_always_on = proto.fan_always_on();
  cooling.min_fan_percent = proto.min_fan_percent();
  cooling.max_fan_percent = proto.max_fan_percent();
  cooling.bridge_fan_percent = proto.bridge_fan_percent();
  cooling.disable_fan_first_layers = proto.disable_fan_first_layers();
  cooling.fan_below_layer_time_s = proto.fan_below_layer_time_s();
  cooling.slowdown_below_layer_time_s = proto.slowdown_below_layer_time_s();
  cooling.min_print_speed_mm_s = proto.min_print_speed_mm_s();
  cooling.consistent_surface = proto.consistent_surface();
  cooling.transition_mm = proto.transition_mm();
  cooling.full_fan_speed_layer = proto.full_fan_speed_layer();
  cooling.dynamic_fan = proto.dynamic_fan();
  Take(proto.overhang_fan_percent(), &cooling.overhang_fan_percent);
  return cooling;
}

v1::ScarfOptions ToProto(const ScarfOptions& options) {
  v1::ScarfOptions proto;
  proto.set_placement(EnumToProto<v1::ScarfPlacement>(options.placement));
  proto.set_only_on_smooth(options.only_on_smooth);
  proto.set_on_inner(options.on_inner);
  proto.set_entire_loop(options.entire_loop);
  proto.set_start_height_ratio(options.start_height_ratio);
  proto.set_length_mm(options.length_mm);
  proto.set_max_segment_mm(options.max_segment_mm);
  return proto;
}

ScarfOptions FromProto(const v1::ScarfOptions& proto) {
  ScarfOptions options;
  options.placement = Known<ScarfPlacement>(proto.placement());
  options.only_on_smooth = proto.only_on_smooth();
  options.on_inner = proto.on_inner();
  options.entire_loop = proto.entire_loop();
  options.start_height_ratio = proto.start_height_ratio();
  options.length_mm = proto.length_mm();
  options.max_segment_mm = proto.max_segment_mm();
  return options;
}

void PutSpeeds(const MotionOptions& options, v1::MotionOptions* proto) {
  for (const RegionSpeeds& region : options.speeds) {
    v1::RegionSpeeds* speeds = proto->add_speeds();
    Put(region.speed_mm_s, speeds->mutable_speed_mm_s());
    speeds->set_small_perimeter_speed_mm_s(region.small_perimeter_speed_mm_s);
    speeds->set_dynamic_overhangs(region.dynamic_overhangs);
    Put(region.overhang_speed_mm_s, speeds->mutable_overhang_speed_mm_s());
    *speeds->mutable_scarf() = ToProto(region.scarf);
    speeds->set_bridging_walls(region.bridging_walls);
    speeds->set_bridge_flow(region.bridge_flow);
    speeds->set_thick_bridges(region.thick_bridges);
  }
  proto->set_travel_speed_mm_s(options.travel_speed_mm_s);
  proto->set_first_layer_travel_speed_mm_s(options.first_layer_travel_speed_mm_s);
  proto->set_travel_speed_z_mm_s(options.travel_speed_z_mm_s);
  proto->set_first_layer_speed_mm_s(options.first_layer_speed_mm_s);
  proto->set_first_layer_speed_ratio(options.first_layer_speed_ratio);
  proto->set_first_layer_infill_speed_mm_s(options.first_layer_infill_speed_mm_s);
  proto->set_over_raft_speed_mm_s(options.over_raft_speed_mm_s);
  proto->set_over_raft_speed_ratio(options.over_raft_speed_ratio);
  proto->set_flow_rise_mm3_s2(options.flow_rise_mm3_s2);
  proto->set_flow_fall_mm3_s2(options.flow_fall_mm3_s2);
  proto->set_over_raft_acceleration_mm_s2(options.over_raft_acceleration_mm_s2);
  proto->set_max_print_speed_mm_s(options.max_print_speed_mm_s);
  proto->set_max_volumetric_speed_mm3_s(options.max_volumetric_speed_mm3_s);
  Put(options.acceleration_mm_s2, proto->mutable_acceleration_mm_s2());
  proto->set_default_acceleration_mm_s2(options.default_acceleration_mm_s2);
  proto->set_first_layer_acceleration_mm_s2(options.first_layer_acceleration_mm_s2);
  proto->set_travel_acceleration_mm_s2(options.travel_acceleration_mm_s2);
  proto->set_short_travel_acceleration_mm_s2(options.short_travel_acceleration_mm_s2);
  proto->set_seam_gap_mm(options.seam_gap_mm);
}

void TakeSpeeds(const v1::MotionOptions& proto, MotionOptions* options) {
  options->speeds.clear();
  for (const v1::RegionSpeeds& region : proto.speeds()) {
    RegionSpeeds& speeds = options->speeds.emplace_back();
    Take(region.speed_mm_s(), &speeds.speed_mm_s);
    speeds.small_perimeter_speed_mm_s = region.small_perimeter_speed_mm_s();
    speeds.dynamic_overhangs = region.dynamic_overhangs();
    Take(region.overhang_speed_mm_s(), &speeds.overhang_speed_mm_s);
    speeds.scarf = FromProto(region.scarf());
    speeds.bridging_walls = region.bridging_walls();
    speeds.bridge_flow = region.bridge_flow();
    speeds.thick_bridges = region.thick_bridges();
  }
  options->travel_speed_mm_s = proto.travel_speed_mm_s();
  options->first_layer_travel_speed_mm_s = proto.first_layer_travel_speed_mm_s();
  options->travel_speed_z_mm_s = proto.travel_speed_z_mm_s();
  options->first_layer_speed_mm_s = proto.first_layer_speed_mm_s();
  options->first_layer_speed_ratio = proto.first_layer_speed_ratio();
  options->first_layer_infill_speed_mm_s = proto.first_layer_infill_speed_mm_s();
  options->over_raft_speed_mm_s = proto.over_raft_speed_mm_s();
  options->over_raft_speed_ratio = proto.over_raft_speed_ratio();
  options->flow_rise_mm3_s2 = proto.flow_rise_mm3_s2();
  options->flow_fall_mm3_s2 = proto.flow_fall_mm3_s2();
  options->over_raft_acceleration_mm_s2 = proto.over_raft_acceleration_mm_s2();
  options->max_print_speed_mm_s = proto.max_print_speed_mm_s();
  options->max_volumetric_speed_mm3_s = proto.max_volumetric_speed_mm3_s();
  Take(proto.acceleration_mm_s2(), &options->acceleration_mm_s2);
  options->default_acceleration_mm_s2 = proto.default_acceleration_mm_s2();
  options->first_layer_acceleration_mm_s2 = proto.first_layer_acceleration_mm_s2();
  options->travel_acceleration_mm_s2 = proto.travel_acceleration_mm_s2();
  options->short_travel_acceleration_mm_s2 = proto.short_travel_acceleration_mm_s2();
  options->seam_gap_mm = proto.seam_gap_mm();
}

void PutMaterial(const MotionOptions& options, v1::MotionOptions* proto) {
  proto->set_nozzle_diameter_mm(options.nozzle_diameter_mm);
  proto->set_filament_diameter_mm(options.filament_diameter_mm);
  proto->set_extrusion_multiplier(options.extrusion_multiplier);
  proto->set_filament_density_g_cm3(options.filament_density_g_cm3);
  proto->set_filament_cost_per_kg(options.filament_cost_per_kg);
  proto->set_filament_type(options.filament_type);
  proto->set_filament_colour(options.filament_colour);
  proto->set_filament_settings_id(options.filament_settings_id);
  proto->set_printer_model(options.printer_model);
  proto->set_pressure_advance(options.pressure_advance);
  proto->set_nozzle_heating_c_s(options.nozzle_heating_c_s);
  proto->set_bed_heating_c_s(options.bed_heating_c_s);
  proto->set_temperature_c(options.temperature_c);
  proto->set_first_layer_temperature_c(options.first_layer_temperature_c);
  proto->set_bed_temperature_c(options.bed_temperature_c);
  proto->set_first_layer_bed_temperature_c(options.first_layer_bed_temperature_c);
  proto->set_chamber_temperature_c(options.chamber_temperature_c);
  proto->set_chamber_least_c(options.chamber_least_c);
  proto->set_emit_temperatures(options.emit_temperatures);
  proto->set_heats_chamber(options.heats_chamber);
  proto->set_tool(options.tool);
}

void TakeMaterial(const v1::MotionOptions& proto, MotionOptions* options) {
  options->nozzle_diameter_mm = proto.nozzle_diameter_mm();
  options->filament_diameter_mm = proto.filament_diameter_mm();
  options->extrusion_multiplier = proto.extrusion_multiplier();
  options->filament_density_g_cm3 = proto.filament_density_g_cm3();
  options->filament_cost_per_kg = proto.filament_cost_per_kg();
  options->filament_type = proto.filament_type();
  options->filament_colour = proto.filament_colour();
  options->filament_settings_id = proto.filament_settings_id();
  options->printer_model = proto.printer_model();
  options->pressure_advance = proto.pressure_advance();
  options->nozzle_heating_c_s = proto.nozzle_heating_c_s();
  options->bed_heating_c_s = proto.bed_heating_c_s();
  options->temperature_c = proto.temperature_c();
  options->first_layer_temperature_c = proto.first_layer_temperature_c();
  options->bed_temperature_c = proto.bed_temperature_c();
  options->first_layer_bed_temperature_c = proto.first_layer_bed_temperature_c();
  options->chamber_temperature_c = proto.chamber_temperature_c();
  options->chamber_least_c = proto.chamber_least_c();
  options->heats_chamber = proto.heats_chamber();
  options->emit_temperatures = proto.emit_temperatures();
  options->tool = proto.tool();
}

void PutWriting(const WritingOptions& options, v1::WritingOptions* proto) {
  proto->set_relative_e(options.relative_e);
  proto->set_volumetric_e(options.volumetric_e);
  proto->set_firmware_retraction(options.firmware_retraction);
  proto->set_comments(options.comments);
  proto->set_binary(options.binary);
  proto->set_substitutions(options.substitutions.str());
  proto->set_file_name(options.file_name);
  proto->set_height_code(options.height_code.str());
  proto->set_color_change_gcode(options.color_change_gcode.str());
  proto->set_pause_gcode(options.pause_gcode.str());
  proto->set_template_gcode(options.template_gcode.str());
}

WritingOptions TakeWriting(const v1::WritingOptions& proto) {
  WritingOptions options;
  options.relative_e = proto.relative_e();
  options.volumetric_e = proto.volumetric_e();
  options.firmware_retraction = proto.firmware_retraction();
  options.comments = proto.comments();
  options.binary = proto.binary();
  options.substitutions = proto.substitutions();
  options.file_name = proto.file_name();
  options.height_code = proto.height_code();
  options.color_change_gcode = proto.color_change_gcode();
  options.pause_gcode = proto.pause_gcode();
  options.template_gcode = proto.template_gcode();
  return options;
}

}  // namespace

absl::Status ToProto(const MotionOptions& options, v1::MotionOptions* proto) {
  proto->set_flavor(EnumToProto<v1::GcodeFlavor>(options.flavor));
  *proto->mutable_limits() = ToProto(options.limits);
  if (options.silent_limits) *proto->mutable_silent_limits() = ToProto(*options.silent_limits);
  *proto->mutable_retraction() = ToProto(options.retraction);
  *proto->mutable_cooling() = ToProto(options.cooling);
  PutSpeeds(options, proto);
  PutMaterial(options, proto);
  proto->set_progress(options.progress);
  proto->set_z_offset_mm(options.z_offset_mm);
  proto->set_start_gcode(options.start_gcode.str());
  proto->set_start_filament_gcode(options.start_filament_gcode.str());
  proto->set_end_gcode(options.end_gcode.str());
  proto->set_before_layer_gcode(options.before_layer_gcode.str());
  proto->set_layer_gcode(options.layer_gcode.str());
  proto->set_layer_settings(options.layer_settings.str());
  proto->set_labels(EnumToProto<v1::ObjectLabels>(options.labels));
  proto->set_between_objects_gcode(options.between_objects_gcode.str());
  proto->set_max_print_height_nm(options.max_print_height_nm);
  proto->set_arc_fitting(EnumToProto<v1::ArcFitting>(options.arc_fitting));
  proto->set_resolution_nm(options.resolution_nm);
  proto->set_material_field(options.material_field.str());
  PutWriting(options.writing, proto->mutable_writing());
  absl::Status status = ToProto(options.extruder_offset, proto->mutable_extruder_offset());
  if (!status.ok()) return Within("extruder_offset", status);
  status = ToProto(options.room, proto->mutable_room());
  return status.ok() ? status : Within("room", status);
}

absl::StatusOr<MotionOptions> FromProto(const v1::MotionOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckSizes(proto));
  status.Update(CheckRanges(proto));
  if (!status.ok()) return status;
  absl::StatusOr<GcodeFlavor> flavor =
      EnumFromProto<GcodeFlavor>(proto.flavor(), kFlavors, "flavor");
  if (!flavor.ok()) return flavor.status();
  absl::StatusOr<MultiPolygon> room = FromProto(proto.room());
  if (!room.ok()) return Within("room", room.status());
  MotionOptions options;
  options.flavor = *flavor;
  options.extruder_offset = FromProto(proto.extruder_offset());
  options.room = *std::move(room);
  options.limits = FromProto(proto.limits());
  if (proto.has_silent_limits()) options.silent_limits = FromProto(proto.silent_limits());
  options.retraction = FromProto(proto.retraction());
  options.cooling = FromProto(proto.cooling());
  TakeSpeeds(proto, &options);
  TakeMaterial(proto, &options);
  options.progress = proto.progress();
  options.z_offset_mm = proto.z_offset_mm();
  options.start_gcode = proto.start_gcode();
  options.start_filament_gcode = proto.start_filament_gcode();
  options.end_gcode = proto.end_gcode();
  options.before_layer_gcode = proto.before_layer_gcode();
  options.layer_gcode = proto.layer_gcode();
  options.layer_settings = proto.layer_settings();
  options.labels = Known<ObjectLabels>(proto.labels());
  options.between_objects_gcode = proto.between_objects_gcode();
  options.max_print_height_nm = proto.max_print_height_nm();
  options.arc_fitting = Known<ArcFitting>(proto.arc_fitting());
  options.resolution_nm = proto.resolution_nm();
  options.material_field = proto.material_field();
  options.writing = TakeWriting(proto.writing());
  return options;
}

}  // namespace slicefarm
