#include "common/wire/layers/program_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "common/base/build_info.h"
#include "common/base/error.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/round_trip_test.h"
#include "google/protobuf/util/message_differencer.h"

namespace slicefarm::program_wire_test {
namespace {

using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;

constexpr LayerFrame kFrame{3, 800'000, 200'000};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
ProgramStats DistinctStats() {
  ProgramStats stats;
  auto& [features, travel_time, retract_time, travel, travels, retractions, bounds] = stats;
  for (int i = 0; i < kFeatureCount; ++i) {
    auto& [time, length, filament, volume] = features[i];
    time = 10 * i + 1;
    length = 10 * i + 2;
    filament = 10 * i + 3;
    volume = 10 * i + 4;
  }
  travel_time = 201;
  retract_time = 209;
  travel = 202;
  travels = 203;
  retractions = 204;
  bounds = {{-205, -206}, {207, 208}};
  return stats;
}

LayerEdges DistinctEdges() {
  LayerEdges edges;
  auto& [head, approach, tail, acceleration] = edges;
  EdgeMove move;
  auto& [x, y, z, filament, feed_rate, move_acceleration, jerk, feature, copy] = move;
  copy = 8;
  x = -301;
  y = 302;
  z = 303;
  filament = -304;
  feed_rate = 305;
  move_acceleration = 306;
  jerk = 308;
  feature = Feature::kGapFill;
  head = {move, {}, {}};
  approach = 2;
  tail = {{}, move};
  acceleration = 307;
  return edges;
}

LayerProgram DistinctProgram() {
  LayerProgram program;
  auto& [frame, pass, gcode, entry, exit, stats, edges, code_at, mode_lines, modes_at_end,
         ends_retracted, footprint, silent_time, copies] = program;
  ends_retracted = false;
  code_at = {2, 5};
  mode_lines = {{1, 2, MachineMode::kFan, "M107"}, {4, 3, MachineMode::kPosition, "1 2"}};
  modes_at_end = {"M106 S9", "", "M204 T7", "3 4", "ready", "M205 X9 Y9"};
  footprint = {{1, 2}, {3, -4}, {5, 6}};
  silent_time = 501;
  copies = {{2, {71, 72, 73, 74}}, {5, {75, 76, 77, 78}}};
  edges = DistinctEdges();
  frame = kFrame;
  pass = 5;
  gcode = std::string("G1 X1\n\0\xff", 8);  // bytes, not text
  entry = {1, -2};
  exit = {-3, 4};
  stats = DistinctStats();
  return program;
}

ProgramSummary DistinctSummary() {
  ProgramSummary summary;
  auto& [layers, total, thumbnails, copies, settings_text] = summary;
  LayerSummary layer;
  auto& [frame, pass, entry, exit, time, empty, edges, filament, layer_footprint, silent_time] =
      layer;
  filament = 9;
  layer_footprint = {{7, 8}, {9, -10}, {11, 12}};
  silent_time = 10;
  edges = DistinctEdges();
  frame = kFrame;
  pass = 7;
  entry = {1, 2};
  exit = {3, 4};
  time = 5;
  empty = true;
  layers = {layer, {{4, 1'000'000, 200'000}, 0, {}, {}, 6, false, DistinctEdges(), 1}};
  total = DistinctStats();
  thumbnails = {{16, 17, "\x89PNG", PictureFormat::kQoi, PictureRole::kTop}};
  CopySummary copy;
  auto& [name, footprint, use] = copy;
  name = {"benchy", 4, 1, 3};
  footprint = {{1, 2}, {3, -4}, {5, 6}};
  use = {51, 52, 53, 54};
  copies = {copy, {{"benchy", 4, 0, 2}, {}}};
  settings_text = "layer_height = 0.2\n";
  return summary;
}

PrintTimes DistinctTimesOfPrint() {
  PrintTimes times;
  auto& [feature, travel, retract, custom, dwell, heating, homings, heat_waits, tool_changes,
         before, layer, after, copies] = times;
  copies = {61, 62};
  for (int i = 0; i < kFeatureCount; ++i) feature[i] = 20 + i;
  travel = 41;
  retract = 42;
  custom = 43;
  dwell = 44;
  heating = 45;
  homings = 46;
  heat_waits = 47;
  tool_changes = 48;
  before = 49;
  layer = {50, 51};
  after = 52;
  return times;
}

ProgramEnvelope DistinctFrame() {
  ProgramEnvelope program;
  auto& [prologue, prefixes, epilogue, times, travel, layer_code, head, tail, file_name] = program;
  head = "head\xff";
  tail = "tail";
  file_name = "name";
  layer_code = {"before", "after"};
  prologue = "start\xff";
  prefixes = {"", "M73 P1\n"};
  epilogue = "end";
  times = DistinctTimesOfPrint();
  travel = 8;
  return program;
}

StageTimes DistinctTimes() {
  StageTimes times;
  double seconds = 0;
  for (const StageInfo& info : kStages) times[info.stage] = ++seconds;
  return times;
}

/// Expects that the message returns unchanged from the model when any single field is changed.
template <typename Proto, typename Model>
void ExpectEveryFieldReturns(const Proto& proto, const std::function<Proto(const Model&)>& render) {
  int fields = 0;
  ForEachChangedField(proto, [&](const std::string& path, const Message& message) {
    if (path.ends_with("options")) return;  // not part of the model
    SCOPED_TRACE(path);
    ++fields;
    const auto& changed = dynamic_cast<const Proto&>(message);
    const absl::StatusOr<Model> meant = FromProto(changed);
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_TRUE(MessageDifferencer::Equals(render(*meant), changed));
  });
  EXPECT_GE(fields, 5);
}

TEST(ProgramWire, ProgramReturns) {
  const auto proto = ProtoOf<v1::LayerProgram>(DistinctProgram());
  const absl::StatusOr<LayerProgram> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, DistinctProgram());
  ExpectEveryFieldReturns<v1::LayerProgram, LayerProgram>(proto,
                                                          ProtoOf<v1::LayerProgram, LayerProgram>);
}

TEST(ProgramWire, BoundsAreNotTheWrongWayRound) {
  auto proto = ProtoOf<v1::LayerProgram>(DistinctProgram());
  proto.mutable_stats()->mutable_max()->set_y_nm(proto.stats().min().y_nm() - 1);
  EXPECT_EQ(FromProto(proto).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(ProgramWire, EmptyProgramReturns) {
  LayerProgram program;
  program.frame = kFrame;
  const auto proto = ProtoOf<v1::LayerProgram>(program);
  EXPECT_FALSE(proto.stats().has_min());
  EXPECT_FALSE(proto.stats().has_max());
  EXPECT_EQ(*FromProto(proto), program);
}

TEST(ProgramWire, SummaryReturns) {
  const auto proto = ProtoOf<v1::ProgramEnvelopeRequest>(DistinctSummary());
  const absl::StatusOr<ProgramSummary> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, DistinctSummary());
  ExpectEveryFieldReturns<v1::ProgramEnvelopeRequest, ProgramSummary>(
      proto, ProtoOf<v1::ProgramEnvelopeRequest, ProgramSummary>);
}

TEST(ProgramWire, FrameReturns) {
  const v1::ProgramEnvelope proto = ToProto(DistinctFrame());
  EXPECT_EQ(*FromProto(proto), DistinctFrame());
  ExpectEveryFieldReturns<v1::ProgramEnvelope, ProgramEnvelope>(
      proto, [](const ProgramEnvelope& frame) { return ToProto(frame); });
}

TEST(ProgramWire, TimesReturn) {
  v1::StageTimes proto = ToProto(DistinctTimes());
  EXPECT_EQ(proto.seconds_size(), static_cast<int>(kStageCount));
  EXPECT_EQ(proto.seconds().at("planning"), 2);
  EXPECT_EQ(*FromProto(proto), DistinctTimes());
  (*proto.mutable_seconds())["weaving"] = 1;
  EXPECT_FALSE(FromProto(proto).ok());
  v1::StageTimes negative;
  (*negative.mutable_seconds())["motion"] = -1;
  EXPECT_FALSE(FromProto(negative).ok());
}

TEST(ProgramWire, EachMemberIsTheFieldOfItsName) {
  const auto program = ProtoOf<v1::LayerProgram>(DistinctProgram());
  EXPECT_EQ(program.pass(), 5);
  EXPECT_EQ(program.entry().x_nm(), 1);
  EXPECT_EQ(program.entry().y_nm(), -2);
  EXPECT_EQ(program.exit().x_nm(), -3);
  const v1::ProgramStats& stats = program.stats();
  EXPECT_EQ(stats.features(1).time_s(), 11);
  EXPECT_EQ(stats.features(1).length_mm(), 12);
  EXPECT_EQ(stats.features(1).filament_mm(), 13);
  EXPECT_EQ(stats.features(1).volume_mm3(), 14);
  EXPECT_EQ(stats.travel_time_s(), 201);
  EXPECT_EQ(stats.travel_mm(), 202);
  EXPECT_EQ(stats.travels(), 203);
  EXPECT_EQ(stats.retractions(), 204);
  EXPECT_EQ(stats.min().y_nm(), -206);
  EXPECT_EQ(stats.max().x_nm(), 207);
  const auto summary = ProtoOf<v1::ProgramEnvelopeRequest>(DistinctSummary());
  EXPECT_EQ(summary.layers(0).pass(), 7);
  EXPECT_EQ(summary.copies(0).name().object(), 4);
  EXPECT_EQ(summary.copies(0).name().copy(), 1);
  EXPECT_THAT(summary.copies(0).footprint_xy_nm(), testing::ElementsAre(1, 2, 3, -4, 5, 6));
  const v1::ProgramEnvelope frame = ToProto(DistinctFrame());
  EXPECT_EQ(frame.epilogue(), "end");
  EXPECT_EQ(frame.times().travel_s(), 41);
  EXPECT_EQ(frame.travel_mm(), 8);
}

struct Refused {
  std::string name;
  std::function<void(v1::LayerProgram&)> spoil;
  std::string field;
};

class ProgramWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(ProgramWireRefuses, NamingTheField) {
  auto proto = ProtoOf<v1::LayerProgram>(DistinctProgram());
  GetParam().spoil(proto);
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field) << status;
}

INSTANTIATE_TEST_SUITE_P(
    Programs, ProgramWireRefuses,
    testing::Values(
        Refused{"NoFrame", [](auto& p) { p.clear_frame(); }, "frame.print_z_nm"},
        Refused{"NegativePass", [](auto& p) { p.set_pass(-1); }, "pass"},
        Refused{"NoStats", [](auto& p) { p.clear_stats(); }, "stats.features"},
        Refused{"AFeatureTooMany", [](auto& p) { p.mutable_stats()->add_features(); },
                "stats.features"},
        Refused{"NanVolume",
                [](auto& p) { p.mutable_stats()->mutable_features(2)->set_volume_mm3(kNan); },
                "stats.features[2].time_s, length_mm, filament_mm, volume_mm3"},
        Refused{"NegativeTravels", [](auto& p) { p.mutable_stats()->set_travels(-1); },
                "stats.travel_time_s, travel_mm, travels, retractions"},
        Refused{"NoMax", [](auto& p) { p.mutable_stats()->clear_max(); }, "stats.min, max"}),
    [](const auto& info) { return info.param.name; });

TEST(ProgramWire, RefusesPointsBeyondTheWire) {
  for (Point LayerProgram::*point : {&LayerProgram::entry, &LayerProgram::exit}) {
    LayerProgram program = DistinctProgram();
    (program.*point).y = Coord{1} << 31;
    v1::LayerProgram proto;
    EXPECT_EQ(DetailOf(ToProto(program, &proto)).reason, Reason::kOutOfRange);
  }
}

TEST(ProgramWire, RefusesSummariesThatNoJobHas) {
  const std::vector<std::pair<std::string, std::function<void(v1::ProgramEnvelopeRequest&)>>>
      spoils = {
          {"layers[1].pass", [](auto& f) { f.mutable_layers(1)->set_pass(-1); }},
          {"layers[1].time_s", [](auto& f) { f.mutable_layers(1)->set_time_s(kNan); }},
          {"copies[0].object",
           [](auto& f) { f.mutable_copies(0)->mutable_name()->set_object(-1); }},
          {"copies[1].copy", [](auto& f) { f.mutable_copies(1)->mutable_name()->set_copy(2); }},
          {"copies[1].copy", [](auto& f) { f.mutable_copies(1)->clear_name(); }},
          {"copies[0].footprint_xy_nm",
           [](auto& f) { f.mutable_copies(0)->add_footprint_xy_nm(1); }},
          {"copies",
           [](auto& f) {
             while (f.copies_size() <= 1'000) *f.add_copies() = f.copies(0);
           }},
      };
  for (const auto& [field, spoil] : spoils) {
    auto proto = ProtoOf<v1::ProgramEnvelopeRequest>(DistinctSummary());
    spoil(proto);
    const absl::Status status = FromProto(proto).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
    EXPECT_EQ(DetailOf(status).metadata["field"], field) << status;
  }
}

TEST(ProgramWire, RefusesFootprintsBeyondTheWire) {
  ProgramSummary summary = DistinctSummary();
  summary.copies[0].footprint[0].x = Coord{1} << 31;
  v1::ProgramEnvelopeRequest proto;
  const absl::Status status = ToProto(summary, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "copies[0]");
}

TEST(LayerWarningWire, Returns) {
  LayerWarning warning;
  auto& [layer, plain_islands] = warning;
  layer = 3;
  plain_islands = 4;
  const v1::LayerWarning proto = ToProto(warning);
  EXPECT_EQ(proto.layer(), 3);
  EXPECT_EQ(proto.plain_islands(), 4);
  EXPECT_EQ(*FromProto(proto), warning);
}

TEST(LayerWarningWire, IsOfALayer) {
  for (const LayerWarning& warning : {LayerWarning{-1, 1}, {20'000, 1}, {0, -1}}) {
    const absl::Status status = FromProto(ToProto(warning)).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  }
}

StageCall CallOf(const std::string& job_id) {
  StageCall call;
  call.job_id = job_id;
  return call;
}

TEST(StageCallWire, ThisBuildIsAccepted) {
  const absl::StatusOr<StageCall> call = FromProto(ToProto(CallOf("job-1")));
  ASSERT_TRUE(call.ok()) << call.status();
  EXPECT_EQ(call->job_id, "job-1");
}

TEST(StageCallWire, AnotherBuildIsRefusedWithBothNames) {
  v1::StageCall proto = ToProto(StageCall{});
  proto.set_build_id("0123456789abcdef");
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(DetailOf(status).reason, Reason::kBuildMismatch);
  EXPECT_EQ(DetailOf(status).metadata["caller"], "0123456789abcdef");
  EXPECT_EQ(DetailOf(status).metadata["callee"], BuildId());
}

TEST(StageCallWire, LongJobIdsAreRefused) {
  const v1::StageCall proto = ToProto(CallOf(std::string(257, 'x')));
  EXPECT_EQ(DetailOf(FromProto(proto).status()).metadata["field"], "job_id");
}

}  // namespace
}  // namespace slicefarm::program_wire_test
