#include "common/wire/layers/exposure_wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "common/model/limits.h"
#include "common/wire/options/exposure_options_wire.h"
#include "common/wire/support/round_trip_test.h"
#include "google/protobuf/util/message_differencer.h"

namespace slicefarm::exposure_wire_test {
namespace {

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
KindExposure DistinctKind(int n) {
  KindExposure kind;
  auto& [vectors, lines, length, time, energy] = kind;
  vectors = 10 * n + 1;
  lines = 10 * n + 2;
  length = 10 * n + 3;
  time = 10 * n + 4;
  energy = 10 * n + 5;
  return kind;
}

ExposureReport DistinctReport() {
  ExposureReport report;
  auto& [kinds, jumps, jump, jump_time, area, volume, cuts, melted, bounds] = report;
  for (int i = 0; i < kExposureKindCount; ++i) kinds[static_cast<size_t>(i)] = DistinctKind(i);
  jumps = 101;
  jump = 102;
  jump_time = 103;
  area = 104;
  volume = 105;
  auto& [pieces, reflex, extra_points, sharp_cuts, replaced] = cuts;
  pieces = 106;
  reflex = 107;
  extra_points = 108;
  sharp_cuts = 109;
  replaced = 110;
  melted = {111, 112, 113, 114, 115, 116};
  bounds = {{-5, -6}, {7, 8}};
  return report;
}

ExposedProgram DistinctProgram() {
  ExposedProgram program;
  auto& [frame, text, report] = program;
  frame = {3, 800'000, 200'000};
  text = std::string("$$\0\xff", 4);  // bytes, not text
  report = DistinctReport();
  return program;
}

ExposureSummary DistinctSummary() {
  ExposureSummary summary;
  auto& [layers, bounds, names, time_s, settings_text] = summary;
  layers = {{0, 50, 50}, {1, 100, 50}};
  bounds = {{1, 2}, {3, 4}};
  names = {"a", "b"};
  time_s = 5.5;
  settings_text = "hatch_distance = 0.1\n";
  return summary;
}

ExposureStyle DistinctStyle(int n) {
  ExposureStyle style;
  auto& [power, speed, focus, frequency, distance, time, delay] = style;
  power = n + 0.1;
  speed = n + 0.2;
  focus = -n - 0.3;
  frequency = n + 0.4;
  distance = n + 5;
  time = n + 0.6;
  delay = n + 0.7;
  return style;
}

ExposureOptions DistinctOptions() {
  ExposureOptions options;
  auto& [strategy, decompose, jump_order, hatch_distance, upskin_distance, downskin_distance,
         hatch_angle, rotation, alternate, gas_flow, gas_window, minimum_vector, stripe_width,
         island_width, overlap, ring_overlap, link_rings, fill_corners, shift_grids, turn_rings,
         spot, compensation, contours, contour_distance, hatch_offset, contours_first,
         contour_start, contour_run, thin_walls, upskin_layers, downskin_layers, skin_overlap,
         z_compensation, skywriting, styles, jump] = options;
  strategy = ScanStrategy::kIslands;
  decompose = DecomposeMethod::kYMonotone;
  jump_order = JumpOrder::kAgainstGas;
  upskin_distance = 1'051;
  downskin_distance = 1'052;
  gas_flow = -53.5;
  gas_window = 20.5;
  contour_start = ContourStart::kRear;
  contour_run = 55;
  z_compensation = 56;
  hatch_distance = 1'001;
  hatch_angle = -2.5;
  rotation = 3.5;
  alternate = false;
  minimum_vector = 5;
  stripe_width = 6'000;
  island_width = 7'000;
  overlap = 8;
  ring_overlap = 9;
  link_rings = false;
  fill_corners = false;
  shift_grids = false;
  turn_rings = false;
  spot = 11;
  compensation = 12;
  contours = 13;
  contour_distance = 1'014;
  hatch_offset = 15;
  contours_first = false;
  thin_walls = false;
  upskin_layers = 18;
  downskin_layers = 19;
  skin_overlap = 20;
  skywriting = 21;
  for (int i = 0; i < kExposureKindCount; ++i)
    styles[static_cast<size_t>(i)] = DistinctStyle(100 * i);
  auto& [speed, delay, mark_delay, polygon_delay] = jump;
  speed = 22;
  delay = 23;
  mark_delay = 24;
  polygon_delay = 25;
  return options;
}

ExposureSettings DistinctSettings() {
  ExposureSettings settings;
  settings.regions = {DistinctOptions(), {}};
  settings.regions[1].upskin_distance_nm = settings.regions[1].downskin_distance_nm = 90'000;
  auto& [format, layer, unit, full_power, full_s, dynamic, recoat, start, before_layer, per_layer,
         end] = settings.output;
  recoat = 34.5;
  start = "start";
  before_layer = "before";
  per_layer = "layer";
  end = "end";
  format = OutputFormat::kMarlin;
  layer = 31;
  unit = 0.5;
  full_power = 32;
  full_s = 33;
  dynamic = false;
  return settings;
}

TEST(ExposureWire, ProgramsAndFramesReturn) {
  ExpectReturns<v1::ExposureReport>(DistinctReport());
  ExpectReturns<v1::ExposureReport>(ExposureReport());
  ExpectReturns<v1::ExposedProgram>(DistinctProgram());
  ExpectReturns<v1::ExposureFrameRequest>(DistinctSummary());
  ExpectReturns<v1::ExposureFrameRequest>(ExposureSummary());
  const ExposureEnvelope frame{std::string("a\0b", 3), {"x", "y"}, "c"};
  EXPECT_EQ(*FromProto(ToProto(frame)), frame);
}

TEST(ExposureWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::ExposedProgram, ExposedProgram>(
      ProtoOf<v1::ExposedProgram>(DistinctProgram()));
  ExpectEveryChangeReturns<v1::ExposureFrameRequest, ExposureSummary>(
      ProtoOf<v1::ExposureFrameRequest>(DistinctSummary()));
}

TEST(ExposureWire, RefusesWhatNoLayerComesTo) {
  using Change = std::function<void(v1::ExposureReport&)>;
  const std::pair<const char*, Change> kCases[] = {
      {"kinds", [](auto& r) { r.mutable_kinds()->RemoveLast(); }},
      {"kinds", [](auto& r) { r.mutable_kinds(1)->set_lines(-1); }},
      {"kinds",
       [](auto& r) { r.mutable_kinds(1)->set_time_s(std::numeric_limits<double>::infinity()); }},
      {"jumps, area_mm2, volume_mm3", [](auto& r) { r.set_jump_mm(-1); }},
      {"cuts", [](auto& r) { r.mutable_cuts()->set_reflex(-1); }},
      {"min, max", [](auto& r) { r.clear_min(); }},
      {"min, max", [](auto& r) { r.mutable_max()->set_x_nm(-6); }}};
  for (const auto& [field, change] : kCases) {
    auto report = ProtoOf<v1::ExposureReport>(DistinctReport());
    change(report);
    ExpectMalformed(FromProto(report).status(), field);
  }
}

TEST(ExposureWire, RefusesSummariesThatNoJobHas) {
  auto summary = ProtoOf<v1::ExposureFrameRequest>(DistinctSummary());
  summary.set_time_s(-1);
  ExpectMalformed(FromProto(summary).status(), "time_s");
  summary.set_time_s(1);
  summary.mutable_layers(1)->set_index(-1);
  EXPECT_FALSE(FromProto(summary).ok());
  summary.mutable_layers(1)->set_index(1);
  summary.add_object_names(std::string(limits::kMaxNameBytes + 1, 'x'));
  EXPECT_EQ(DetailOf(FromProto(summary).status()).reason, Reason::kRequestTooLarge);
}

TEST(ExposureWire, SettingsReturn) {
  const auto back = FromProto(ToProto(DistinctSettings()));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, DistinctSettings());
  int accepted = 0;
  const v1::ExposureSettings original = ToProto(DistinctSettings());
  ForEachChangedField(original, [&](const std::string& path, const auto& message) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const v1::ExposureSettings&>(message);
    const auto meant = FromProto(changed);
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_NE(*meant, DistinctSettings());
    EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(ToProto(*meant), changed));
    ++accepted;
  });
  EXPECT_GT(accepted, 100);
}

TEST(ExposureWire, RefusesSettingsThatNoResolverMakes) {
  using Change = std::function<void(v1::ExposureSettings&)>;
  const std::pair<const char*, Change> kCases[] = {
      {"regions", [](auto& s) { s.clear_regions(); }},
      {"regions[0].hatch_distance_nm",
       [](auto& s) { s.mutable_regions(0)->set_hatch_distance_nm(0); }},
      {"regions[1].spot_nm", [](auto& s) { s.mutable_regions(1)->set_spot_nm(0); }},
      {"regions[0].strategy",
       [](auto& s) { s.mutable_regions(0)->set_strategy(v1::SCAN_STRATEGY_UNSPECIFIED); }},
      {"regions[0].contours or skin layers",
       [](auto& s) { s.mutable_regions(0)->set_contours(-1); }},
      {"regions[0].styles", [](auto& s) { s.mutable_regions(0)->mutable_styles()->RemoveLast(); }},
      {"regions[0].styles",
       [](auto& s) { s.mutable_regions(0)->mutable_styles(2)->set_power_w(-1); }},
      {"regions[0].speed_mm_s",
       [](auto& s) { s.mutable_regions(0)->mutable_styles(2)->set_speed_mm_s(0); }},
      {"regions[0].jump", [](auto& s) { s.mutable_regions(0)->mutable_jump()->set_delay_us(-1); }},
      {"regions[0].jump.speed_mm_s",
       [](auto& s) { s.mutable_regions(0)->mutable_jump()->set_speed_mm_s(0); }},
      {"regions[0].contour_distance_nm",
       [](auto& s) { s.mutable_regions(0)->set_contour_distance_nm(10); }},
      {"regions[0].stripe_width_nm, island_width_nm",
       [](auto& s) { s.mutable_regions(0)->set_stripe_width_nm(1'000); }},
      {"regions[0].overlap_nm", [](auto& s) { s.mutable_regions(0)->set_overlap_nm(3'100); }},
      {"regions[0].ring_overlap_nm",
       [](auto& s) { s.mutable_regions(0)->set_ring_overlap_nm(1'002); }},
      {"regions[0].beam_compensation_nm",
       [](auto& s) { s.mutable_regions(0)->set_beam_compensation_nm(-5); }},
      {"regions[0].hatch_offset_nm",
       [](auto& s) { s.mutable_regions(0)->set_hatch_offset_nm(-1); }},
      {"regions[0].skywriting_nm", [](auto& s) { s.mutable_regions(0)->set_skywriting_nm(-1); }},
      {"regions[0].contours or skin layers",
       [](auto& s) { s.mutable_regions(0)->set_downskin_layers(1'001); }},
      {"regions[0].contours or skin layers",
       [](auto& s) { s.mutable_regions(0)->set_z_compensation_layers(-1); }},
      {"regions[0].upskin_distance_nm, downskin_distance_nm",
       [](auto& s) { s.mutable_regions(0)->set_downskin_distance_nm(999); }},
      {"regions[0].gas_window_deg", [](auto& s) { s.mutable_regions(0)->set_gas_window_deg(23); }},
      {"regions[1].gas_window_deg", [](auto& s) { s.mutable_regions(1)->set_gas_window_deg(46); }},
      {"regions[0].contour_run_nm", [](auto& s) { s.mutable_regions(0)->set_contour_run_nm(-1); }},
      {"output.recoat_s", [](auto& s) { s.mutable_output()->set_recoat_s(-1); }},
      {"regions[0].hatch_angle_deg",
       [](auto& s) {
         s.mutable_regions(0)->set_hatch_angle_deg(std::numeric_limits<double>::quiet_NaN());
       }},
      {"regions[0].focus_mm",
       [](auto& s) {
         s.mutable_regions(0)->mutable_styles(0)->set_focus_mm(
             std::numeric_limits<double>::infinity());
       }},
      {"output.unit_mm", [](auto& s) { s.mutable_output()->set_unit_mm(0); }},
      {"output.layer", [](auto& s) { s.mutable_output()->set_layer(-1); }}};
  for (const auto& [field, change] : kCases) {
    v1::ExposureSettings settings = ToProto(DistinctSettings());
    change(settings);
    ExpectMalformed(FromProto(settings).status(), field);
  }
}

}  // namespace
}  // namespace slicefarm::exposure_wire_test
