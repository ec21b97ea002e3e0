#include "common/wire/milling/milling_options_wire.h"

#include <utility>

#include "common/model/milling/cutter_text.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::CUT_DIRECTION_CONVENTIONAL == static_cast<int>(CutDirection::kConventional) + 1);
static_assert(v1::ENTRY_KIND_PLUNGE == static_cast<int>(EntryKind::kPlunge) + 1);
static_assert(v1::COOLANT_FLOOD == static_cast<int>(Coolant::kFlood) + 1);
static_assert(v1::MILL_DIALECT_GRBL == static_cast<int>(MillDialect::kGrbl) + 1);
static_assert(v1::MILL_ORIGIN_STOCK_TOP == static_cast<int>(MillOrigin::kStockTop) + 1);
static_assert(v1::MILL_FORMAT_SVG == static_cast<int>(MillFormat::kSvg) + 1);

void Put(const MachiningOptions& machining, v1::MachiningOptions* proto) {
  proto->set_direction(EnumToProto<v1::CutDirection>(machining.direction));
  proto->set_entry(EnumToProto<v1::EntryKind>(machining.entry));
  proto->set_ramp_angle_deg(machining.ramp_angle_deg);
  proto->set_helix_radius_mm(machining.helix_radius_mm);
  proto->set_lead_in_radius_mm(machining.lead_in_radius_mm);
  proto->set_arcs(machining.arcs);
  proto->set_safe_height_mm(machining.safe_height_mm);
  proto->set_clearance_mm(machining.clearance_mm);
  proto->set_feed_mm_min(machining.feed_mm_min);
  proto->set_plunge_feed_mm_min(machining.plunge_feed_mm_min);
  proto->set_rapid_mm_min(machining.rapid_mm_min);
  proto->set_spindle_rpm(machining.spindle_rpm);
  proto->set_coolant(EnumToProto<v1::Coolant>(machining.coolant));
  proto->set_tool_number(machining.tool_number);
  proto->set_tool_length_mm(machining.tool_length_mm);
  proto->set_max_acceleration_x_mm_s2(machining.max_acceleration_mm_s2[0]);
  proto->set_max_acceleration_y_mm_s2(machining.max_acceleration_mm_s2[1]);
  proto->set_max_acceleration_z_mm_s2(machining.max_acceleration_mm_s2[2]);
  proto->set_jerk_mm_s3(machining.jerk_mm_s3);
  proto->set_corner_feeds(machining.corner_feeds);
}

MachiningOptions Taken(const v1::MachiningOptions& proto) {
  MachiningOptions machining;
  machining.direction = Known<CutDirection>(proto.direction());
  machining.entry = Known<EntryKind>(proto.entry());
  machining.ramp_angle_deg = proto.ramp_angle_deg();
  machining.helix_radius_mm = proto.helix_radius_mm();
  machining.lead_in_radius_mm = proto.lead_in_radius_mm();
  machining.arcs = proto.arcs();
  machining.safe_height_mm = proto.safe_height_mm();
  machining.clearance_mm = proto.clearance_mm();
  machining.feed_mm_min = proto.feed_mm_min();
  machining.plunge_feed_mm_min = proto.plunge_feed_mm_min();
  machining.rapid_mm_min = proto.rapid_mm_min();
  machining.spindle_rpm = proto.spindle_rpm();
  machining.coolant = Known<Coolant>(proto.coolant());
  machining.tool_number = proto.tool_number();
  machining.tool_length_mm = proto.tool_length_mm();
  machining.max_acceleration_mm_s2 = {proto.max_acceleration_x_mm_s2(),
                                      proto.max_acceleration_y_mm_s2(),
                                      proto.max_acceleration_z_mm_s2()};
  machining.jerk_mm_s3 = proto.jerk_mm_s3();
  machining.corner_feeds = proto.corner_feeds();
  return machining;
}

void Put(const MillingOptions& how, v1::MillingOptions* proto) {
  proto->set_cutter(how.cutter.name());
  proto->set_stepdown_mm(how.stepdown_mm);
  proto->set_stepover_share(how.stepover_share);
  proto->set_allowance_mm(how.allowance_mm);
  proto->set_minimum_width_mm(how.minimum_width_mm);
  proto->set_finishing(how.finishing);
  proto->set_finish_stepdown_mm(how.finish_stepdown_mm);
  proto->set_finish_stepover_mm(how.finish_stepover_mm);
  proto->set_rest_angle_deg(how.rest_angle_deg);
  proto->set_finish_floor(how.finish_floor);
  proto->set_sampling_mm(how.sampling_mm);
  proto->set_tolerance_mm(how.tolerance_mm);
  proto->set_stock_margin_mm(how.stock_margin_mm);
  proto->set_bottom_mm(how.bottom_mm);
  proto->set_open_mesh(how.open_mesh);
  Put(how.machining, proto->mutable_machining());
}

absl::StatusOr<MillingOptions> Taken(const v1::MillingOptions& proto) {
  absl::StatusOr<Cutter> cutter = ParseCutter(proto.cutter());
  if (!cutter.ok()) return cutter.status();
  MillingOptions how;
  how.cutter = *std::move(cutter);
  how.stepdown_mm = proto.stepdown_mm();
  how.stepover_share = proto.stepover_share();
  how.allowance_mm = proto.allowance_mm();
  how.minimum_width_mm = proto.minimum_width_mm();
  how.finishing = proto.finishing();
  how.finish_stepdown_mm = proto.finish_stepdown_mm();
  how.finish_stepover_mm = proto.finish_stepover_mm();
  how.rest_angle_deg = proto.rest_angle_deg();
  how.finish_floor = proto.finish_floor();
  how.sampling_mm = proto.sampling_mm();
  how.tolerance_mm = proto.tolerance_mm();
  how.stock_margin_mm = proto.stock_margin_mm();
  how.bottom_mm = proto.bottom_mm();
  how.open_mesh = proto.open_mesh();
  how.machining = Taken(proto.machining());
  return how;
}

}  // namespace

absl::Status ToProto(const MillSettings& settings, v1::MillSettings* proto) {
  Put(settings.how, proto->mutable_how());
  proto->set_stock(settings.stock);
  proto->set_origin(EnumToProto<v1::MillOrigin>(settings.origin));
  proto->set_dialect(EnumToProto<v1::MillDialect>(settings.dialect));
  proto->set_format(EnumToProto<v1::MillFormat>(settings.format));
  proto->set_output_step(settings.output_step);
  return absl::OkStatus();
}

absl::StatusOr<MillSettings> FromProto(const v1::MillSettings& proto) {
  if (absl::Status complete = CheckComplete(proto); !complete.ok()) return complete;
  absl::StatusOr<MillingOptions> how = Taken(proto.how());
  if (!how.ok()) return how.status();
  if (proto.output_step() < 0) return Malformed("output_step", "is negative");
  MillSettings settings;
  settings.how = *std::move(how);
  settings.stock = proto.stock();
  settings.origin = Known<MillOrigin>(proto.origin());
  settings.dialect = Known<MillDialect>(proto.dialect());
  settings.format = Known<MillFormat>(proto.format());
  settings.output_step = proto.output_step();
  return settings;
}

}  // namespace slicefarm
