#include "common/wire/layers/exposure_wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "common/model/limits.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::exposure_wire_test {
namespace {

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
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

TEST(ExposureWire, ProgramsAndFramesReturn) {
  ExpectReturns<v1::ExposureReport>(DistinctReport());
  ExpectReturns<v1::ExposureReport>(ExposureReport());
  ExpectReturns<v1::ExposedProgram>(DistinctProgram());
  ExpectReturns<v1::ExposureEnvelopeRequest>(DistinctSummary());
  ExpectReturns<v1::ExposureEnvelopeRequest>(ExposureSummary());
  const ExposureEnvelope frame{std::string("a\0b", 3), {"x", "y"}, "c"};
  EXPECT_EQ(*FromProto(ToProto(frame)), frame);
}

TEST(ExposureWire, EveryFieldChangedAloneReturns) {
  ExpectEveryChangeReturns<v1::ExposedProgram, ExposedProgram>(
      ProtoOf<v1::ExposedProgram>(DistinctProgram()));
  ExpectEveryChangeReturns<v1::ExposureEnvelopeRequest, ExposureSummary>(
      ProtoOf<v1::ExposureEnvelopeRequest>(DistinctSummary()), {}, {"settings"});
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
  auto summary = ProtoOf<v1::ExposureEnvelopeRequest>(DistinctSummary());
  summary.set_time_s(-1);
  ExpectMalformed(FromProto(summary).status(), "time_s");
  summary.set_time_s(1);
  summary.mutable_layers(1)->set_index(-1);
  EXPECT_FALSE(FromProto(summary).ok());
  summary.mutable_layers(1)->set_index(1);
  summary.add_object_names(std::string(limits::kMaxNameBytes + 1, 'x'));
  EXPECT_EQ(DetailOf(FromProto(summary).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::exposure_wire_test
