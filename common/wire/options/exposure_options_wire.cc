#include "common/wire/options/exposure_options_wire.h"

#include <algorithm>

#include "common/model/limits.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

/// Finer lines have no meaning, and would take all memory.
constexpr Coord kLeastHatchNm = 1'000;
constexpr int32_t kMaxCount = 1'000;  ///< of contours, and of layers that skins reach

static_assert(v1::SCAN_STRATEGY_RINGS == static_cast<int>(ScanStrategy::kRings) + 1);
static_assert(v1::SCAN_STRATEGY_HATCH == static_cast<int>(ScanStrategy::kHatch) + 1);
static_assert(v1::DECOMPOSE_METHOD_Y_MONOTONE == static_cast<int>(DecomposeMethod::kYMonotone) + 1);
static_assert(v1::JUMP_ORDER_AGAINST_GAS == static_cast<int>(JumpOrder::kAgainstGas) + 1);
static_assert(v1::CONTOUR_START_REAR == static_cast<int>(ContourStart::kRear) + 1);
static_assert(v1::OUTPUT_FORMAT_DXF == static_cast<int>(OutputFormat::kDxf) + 1);

absl::Status IsPositive(std::string_view field, double value) {
  return value > 0 ? absl::OkStatus() : Malformed(field, "is not positive");
}

absl::Status CheckStyle(const v1::ExposureStyle& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckNotNegative({{"point_distance_nm", proto.point_distance_nm()}}));
  for (const double value :
       {proto.power_w(), proto.frequency_khz(), proto.point_time_us(), proto.point_delay_us()})
    if (value < 0) status.Update(Malformed("styles", "an amount is negative"));
  status.Update(IsPositive("speed_mm_s", proto.speed_mm_s()));
  return status;
}

absl::Status Check(const v1::ExposureOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckLengths({{"hatch_distance_nm", proto.hatch_distance_nm()},
                              {"contour_distance_nm", proto.contour_distance_nm()}},
                             kLeastHatchNm));
  status.Update(CheckPositive({{"stripe_width_nm", proto.stripe_width_nm()},
                               {"island_width_nm", proto.island_width_nm()},
                               {"spot_nm", proto.spot_nm()}}));
  status.Update(CheckNotNegative({{"minimum_vector_nm", proto.minimum_vector_nm()},
                                  {"overlap_nm", proto.overlap_nm()},
                                  {"ring_overlap_nm", proto.ring_overlap_nm()},
                                  {"beam_compensation_nm", proto.beam_compensation_nm()},
                                  {"hatch_offset_nm", proto.hatch_offset_nm()},
                                  {"skin_overlap_nm", proto.skin_overlap_nm()},
                                  {"skywriting_nm", proto.skywriting_nm()},
                                  {"contour_run_nm", proto.contour_run_nm()}}));
  for (const Coord distance : {proto.upskin_distance_nm(), proto.downskin_distance_nm()})
    if (distance != 0 && distance < kLeastHatchNm)
      status.Update(Malformed("upskin_distance_nm, downskin_distance_nm", "too small"));
  const bool both_ways = proto.strategy() == v1::SCAN_STRATEGY_ISLANDS;
  const double widest = both_ways ? kWidestGasWindowDeg / 2 : kWidestGasWindowDeg;
  if (proto.gas_window_deg() < 0 || proto.gas_window_deg() > widest)
    status.Update(Malformed("gas_window_deg", "out of range"));
  for (const int32_t count : {proto.contours(), proto.upskin_layers(), proto.downskin_layers(),
                              proto.z_compensation_layers()})
    if (count < 0 || count > kMaxCount)
      status.Update(Malformed("contours or skin layers", "out of range"));
  const Coord narrowest = std::min(proto.stripe_width_nm(), proto.island_width_nm());
  if (narrowest < std::max({proto.hatch_distance_nm(), proto.upskin_distance_nm(),
                            proto.downskin_distance_nm()}))
    status.Update(Malformed("stripe_width_nm, island_width_nm", "less than the hatch distance"));
  // Cells that reach into the next but one would be scanned thrice.
  if (proto.overlap_nm() > narrowest / 2)
    status.Update(Malformed("overlap_nm", "more than half of a stripe or island"));
  if (proto.ring_overlap_nm() > proto.hatch_distance_nm())
    status.Update(Malformed("ring_overlap_nm", "more than the hatch distance"));
  if (proto.styles_size() != kExposureKindCount)
    status.Update(Malformed("styles", "not one for each kind of vector"));
  for (const v1::ExposureStyle& style : proto.styles()) status.Update(CheckStyle(style));
  status.Update(IsPositive("jump.speed_mm_s", proto.jump().speed_mm_s()));
  for (const double delay :
       {proto.jump().delay_us(), proto.jump().mark_delay_us(), proto.jump().polygon_delay_us()})
    if (delay < 0) status.Update(Malformed("jump", "a delay is negative"));
  return status;
}

absl::Status Check(const v1::ExposureOutput& proto) {
  absl::Status status = IsPositive("unit_mm", proto.unit_mm());
  status.Update(IsPositive("full_power_w", proto.full_power_w()));
  status.Update(IsPositive("full_power_s", proto.full_power_s()));
  if (proto.layer() < 0) status.Update(Malformed("layer", "is negative"));
  if (!(proto.recoat_s() >= 0)) status.Update(Malformed("recoat_s", "is negative"));
  return status;
}

v1::ExposureStyle ToProto(const ExposureStyle& options) {
  v1::ExposureStyle proto;
  proto.set_power_w(options.power_w);
  proto.set_speed_mm_s(options.speed_mm_s);
  proto.set_focus_mm(options.focus_mm);
  proto.set_frequency_khz(options.frequency_khz);
  proto.set_point_distance_nm(options.point_distance_nm);
  proto.set_point_time_us(options.point_time_us);
  proto.set_point_delay_us(options.point_delay_us);
  return proto;
}

ExposureStyle StyleOf(const v1::ExposureStyle& proto) {
  ExposureStyle options;
  options.power_w = proto.power_w();
  options.speed_mm_s = proto.speed_mm_s();
  options.focus_mm = proto.focus_mm();
  options.frequency_khz = proto.frequency_khz();
  options.point_distance_nm = proto.point_distance_nm();
  options.point_time_us = proto.point_time_us();
  options.point_delay_us = proto.point_delay_us();
  return options;
}

v1::JumpOptions ToProto(const JumpOptions& options) {
  v1::JumpOptions proto;
  proto.set_speed_mm_s(options.speed_mm_s);
  proto.set_delay_us(options.delay_us);
  proto.set_mark_delay_us(options.mark_delay_us);
  proto.set_polygon_delay_us(options.polygon_delay_us);
  return proto;
}

JumpOptions JumpOf(const v1::JumpOptions& proto) {
  JumpOptions options;
  options.speed_mm_s = proto.speed_mm_s();
  options.delay_us = proto.delay_us();
  options.mark_delay_us = proto.mark_delay_us();
  options.polygon_delay_us = proto.polygon_delay_us();
  return options;
}

v1::ExposureOptions ToProto(const ExposureOptions& options) {
  v1::ExposureOptions proto;
  proto.set_strategy(EnumToProto<v1::ScanStrategy>(options.strategy));
  proto.set_decompose(EnumToProto<v1::DecomposeMethod>(options.decompose));
  proto.set_jump_order(EnumToProto<v1::JumpOrder>(options.jump_order));
  proto.set_hatch_distance_nm(options.hatch_distance_nm);
  proto.set_hatch_angle_deg(options.hatch_angle_deg);
  proto.set_layer_rotation_deg(options.layer_rotation_deg);
  proto.set_alternate_directions(options.alternate_directions);
  proto.set_minimum_vector_nm(options.minimum_vector_nm);
  proto.set_stripe_width_nm(options.stripe_width_nm);
  proto.set_island_width_nm(options.island_width_nm);
  proto.set_overlap_nm(options.overlap_nm);
  proto.set_ring_overlap_nm(options.ring_overlap_nm);
  proto.set_link_rings(options.link_rings);
  proto.set_fill_corners(options.fill_corners);
  proto.set_shift_grids(options.shift_grids);
  proto.set_turn_rings(options.turn_rings);
  proto.set_upskin_distance_nm(options.upskin_distance_nm);
  proto.set_downskin_distance_nm(options.downskin_distance_nm);
  proto.set_gas_flow_deg(options.gas_flow_deg);
  proto.set_gas_window_deg(options.gas_window_deg);
  proto.set_contour_start(EnumToProto<v1::ContourStart>(options.contour_start));
  proto.set_contour_run_nm(options.contour_run_nm);
  proto.set_z_compensation_layers(options.z_compensation_layers);
  proto.set_spot_nm(options.spot_nm);
  proto.set_beam_compensation_nm(options.beam_compensation_nm);
  proto.set_contours(options.contours);
  proto.set_contour_distance_nm(options.contour_distance_nm);
  proto.set_hatch_offset_nm(options.hatch_offset_nm);
  proto.set_contours_first(options.contours_first);
  proto.set_thin_walls(options.thin_walls);
  proto.set_upskin_layers(options.upskin_layers);
  proto.set_downskin_layers(options.downskin_layers);
  proto.set_skin_overlap_nm(options.skin_overlap_nm);
  proto.set_skywriting_nm(options.skywriting_nm);
  for (const ExposureStyle& style : options.styles) *proto.add_styles() = ToProto(style);
  *proto.mutable_jump() = ToProto(options.jump);
  return proto;
}

ExposureOptions OptionsOf(const v1::ExposureOptions& proto) {
  ExposureOptions options;
  options.strategy = Known<ScanStrategy>(proto.strategy());
  options.decompose = Known<DecomposeMethod>(proto.decompose());
  options.jump_order = Known<JumpOrder>(proto.jump_order());
  options.hatch_distance_nm = proto.hatch_distance_nm();
  options.hatch_angle_deg = proto.hatch_angle_deg();
  options.layer_rotation_deg = proto.layer_rotation_deg();
  options.alternate_directions = proto.alternate_directions();
  options.minimum_vector_nm = proto.minimum_vector_nm();
  options.stripe_width_nm = proto.stripe_width_nm();
  options.island_width_nm = proto.island_width_nm();
  options.overlap_nm = proto.overlap_nm();
  options.ring_overlap_nm = proto.ring_overlap_nm();
  options.link_rings = proto.link_rings();
  options.fill_corners = proto.fill_corners();
  options.shift_grids = proto.shift_grids();
  options.turn_rings = proto.turn_rings();
  options.upskin_distance_nm = proto.upskin_distance_nm();
  options.downskin_distance_nm = proto.downskin_distance_nm();
  options.gas_flow_deg = proto.gas_flow_deg();
  options.gas_window_deg = proto.gas_window_deg();
  options.contour_start = Known<ContourStart>(proto.contour_start());
  options.contour_run_nm = proto.contour_run_nm();
  options.z_compensation_layers = proto.z_compensation_layers();
  options.spot_nm = proto.spot_nm();
  options.beam_compensation_nm = proto.beam_compensation_nm();
  options.contours = proto.contours();
  options.contour_distance_nm = proto.contour_distance_nm();
  options.hatch_offset_nm = proto.hatch_offset_nm();
  options.contours_first = proto.contours_first();
  options.thin_walls = proto.thin_walls();
  options.upskin_layers = proto.upskin_layers();
  options.downskin_layers = proto.downskin_layers();
  options.skin_overlap_nm = proto.skin_overlap_nm();
  options.skywriting_nm = proto.skywriting_nm();
  for (int i = 0; i < kExposureKindCount; ++i)
    options.styles[static_cast<size_t>(i)] = StyleOf(proto.styles(i));
  options.jump = JumpOf(proto.jump());
  return options;
}

v1::ExposureOutput ToProto(const ExposureOutput& options) {
  v1::ExposureOutput proto;
  proto.set_format(EnumToProto<v1::OutputFormat>(options.format));
  proto.set_layer(options.layer);
  proto.set_unit_mm(options.unit_mm);
  proto.set_full_power_w(options.full_power_w);
  proto.set_full_power_s(options.full_power_s);
  proto.set_dynamic_power(options.dynamic_power);
  proto.set_recoat_s(options.recoat_s);
  proto.set_start_gcode(options.start_gcode.str());
  proto.set_before_layer_gcode(options.before_layer_gcode.str());
  proto.set_layer_gcode(options.layer_gcode.str());
  proto.set_end_gcode(options.end_gcode.str());
  return proto;
}

ExposureOutput OutputOf(const v1::ExposureOutput& proto) {
  ExposureOutput options;
  options.format = Known<OutputFormat>(proto.format());
  options.layer = proto.layer();
  options.unit_mm = proto.unit_mm();
  options.full_power_w = proto.full_power_w();
  options.full_power_s = proto.full_power_s();
  options.dynamic_power = proto.dynamic_power();
  options.recoat_s = proto.recoat_s();
  options.start_gcode = proto.start_gcode();
  options.before_layer_gcode = proto.before_layer_gcode();
  options.layer_gcode = proto.layer_gcode();
  options.end_gcode = proto.end_gcode();
  return options;
}

}  // namespace

v1::ExposureSettings ToProto(const ExposureSettings& settings) {
  v1::ExposureSettings proto;
  for (const ExposureOptions& region : settings.regions) *proto.add_regions() = ToProto(region);
  *proto.mutable_output() = ToProto(settings.output);
  return proto;
}

absl::StatusOr<ExposureSettings> FromProto(const v1::ExposureSettings& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckRows(proto.regions_size(), "regions"));
  if (!status.ok()) return status;
  ExposureSettings settings;
  settings.regions.clear();
  for (int i = 0; i < proto.regions_size(); ++i) {
    if (absl::Status ok = Check(proto.regions(i)); !ok.ok()) return Within("regions", i, ok);
    settings.regions.push_back(OptionsOf(proto.regions(i)));
  }
  if (absl::Status ok = Check(proto.output()); !ok.ok()) return Within("output", ok);
  settings.output = OutputOf(proto.output());
  return settings;
}

}  // namespace slicefarm
