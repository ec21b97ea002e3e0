#include "common/wire/layers/plan_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::plan_wire_test {
namespace {

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
Copy DistinctCopy() {
  Copy copy;
  auto& [object, shift, pass] = copy;
  object = 1;
  shift = {2'000, -3'000};
  pass = 4;
  return copy;
}

PlacedCopy DistinctPlaced() {
  PlacedCopy copy;
  auto& [object, shift, footprint] = copy;
  object = 1;
  shift = {2'000, -3'000};
  footprint = {{4, 5}, {-6, 7}, {8, -9}};
  return copy;
}

SectionPlan DistinctSection(int32_t of) {
  SectionPlan plan;
  auto& [stack, entry, exit, seams, above_supports, spiral, curled, air] = plan;
  stack = of;
  entry = {2, -3};
  exit = {-8, 9};
  seams = {{4, 5}, {-6, 7}};
  above_supports = MakePolygonsOrDie("(2 2, 7 2, 7 7)");
  curled = MakePolygonsOrDie("(3 3, 8 3, 8 8)");
  air = MakePolygonsOrDie("(4 4, 9 4, 9 9)");
  spiral = {{10, 11}, Point{-12, 13}, true, false};
  return plan;
}

PlannedInfill DistinctInfill(int32_t of) {
  PlannedInfill plan;
  auto& [stack, settings, pattern, lines, left_out, combined, combined_height, middles] = plan;
  stack = of;
  settings = 2;
  pattern = FillPattern::kLightning;
  lines = {{{1, 2}, {-3, 4}}, {{5, 6}, {7, 8}, {-9, 10}}};
  left_out = MakePolygonsOrDie("(0 0, 9 0, 9 9)");
  combined = MakePolygonsOrDie("(1 1, 8 1, 8 8)");
  combined_height = 600'000;
  middles = {{11, -12}, {13, 14}};
  return plan;
}

LayerPlan DistinctLayer() {
  LayerPlan plan;
  auto& [entry, begins_ready, ends_ready, sections, paths, infill, paths_height] = plan;
  entry = {-1, 2};
  begins_ready = true;
  ends_ready = true;
  sections = {DistinctSection(3), DistinctSection(5)};
  paths = {MakePathOrDie("(0 0, 9 0, 9 9)", true)};
  paths_height = 230'000;
  infill = {DistinctInfill(3), DistinctInfill(4)};
  return plan;
}

AddedStack DistinctStack() {
  AddedStack added;
  auto& [stack, lift, sections] = added;
  stack = Stack(7, 3, StackKind::kSupport);
  lift = 250'000;
  return added;
}

Skirt DistinctSkirt() {
  Skirt skirt;
  auto& [loops, layers, upper_loops] = skirt;
  loops = {MakePathOrDie("(0 0, 9 0, 9 9)", true)};
  upper_loops = {MakePathOrDie("(0 0, 8 0, 8 8)", true)};
  layers = 12;
  return skirt;
}

CopyName DistinctName() {
  CopyName name;
  auto& [object_name, object, copy, copies] = name;
  object_name = "benchy";
  object = 5;
  copy = 1;
  copies = 3;
  return name;
}

JobFacts DistinctFacts() {
  JobFacts facts;
  auto& [layer_count, copies, passes] = facts;
  layer_count = 40;
  PassFacts pass;
  auto& [layers_before, first_layer, top_before] = pass;
  layers_before = 20;
  first_layer = 2;
  top_before = 4'000'000;
  passes = {{}, pass};
  copies = {DistinctName(), {"other", 6, 0, 1}};
  return facts;
}

SeamQuality DistinctQuality() {
  SeamQuality quality;
  auto& [loops, followers, jumps, steps, with_corner, on_corner, overhanging] = quality;
  loops = 90;
  followers = 80;
  jumps = 7;
  steps = 6.5;
  with_corner = 50;
  on_corner = 40;
  overhanging = 3;
  return quality;
}

TEST(PlanWire, Returns) {
  ExpectReturns<v1::Copy>(DistinctCopy());
  ExpectReturns<v1::PlacedCopy>(DistinctPlaced());
  ExpectReturns<v1::SectionPlan>(DistinctSection(1));
  ExpectReturns<v1::PlannedInfill>(DistinctInfill(1));
  ExpectReturns<v1::LayerPlan>(DistinctLayer());
  ExpectReturns<v1::AddedStack>(DistinctStack());
  ExpectReturns<v1::Skirt>(DistinctSkirt());
  EXPECT_EQ(*FromProto(ToProto(DistinctName())), DistinctName());
  EXPECT_EQ(*FromProto(ToProto(DistinctFacts())), DistinctFacts());
  EXPECT_EQ(*FromProto(ToProto(DistinctQuality())), DistinctQuality());
}

TEST(PlanWire, EmptyReturns) {
  ExpectReturns<v1::Copy>(Copy{});
  ExpectReturns<v1::PlacedCopy>(PlacedCopy{});
  ExpectReturns<v1::SectionPlan>(SectionPlan{});
  ExpectReturns<v1::LayerPlan>(LayerPlan{});
  ExpectReturns<v1::AddedStack>(AddedStack{});
  ExpectReturns<v1::Skirt>(Skirt{});
  EXPECT_EQ(*FromProto(ToProto(JobFacts{})), JobFacts{});
}

TEST(PlanWire, EveryFieldChangedAloneReturns) {
  // A shift increased by one nanometre is no whole micrometre.
  ExpectEveryChangeReturns<v1::PlacedCopy, PlacedCopy>(ProtoOf<v1::PlacedCopy>(DistinctPlaced()),
                                                       {"shift"});
  ExpectEveryChangeReturns<v1::SectionPlan, SectionPlan>(
      ProtoOf<v1::SectionPlan>(DistinctSection(1)), {"ring_sizes", "rings_per_island"});
  // The stacks of infill must ascend.
  ExpectEveryChangeReturns<v1::LayerPlan, LayerPlan>(
      ProtoOf<v1::LayerPlan>(DistinctLayer()),
      {"ring_sizes", "rings_per_island", "line_sizes", "infill[0].stack"});
  ExpectEveryChangeReturns<v1::AddedStack, AddedStack>(ProtoOf<v1::AddedStack>(DistinctStack()),
                                                       {"stack.kind"});
  ExpectEveryChangeReturns<v1::Skirt, Skirt>(ProtoOf<v1::Skirt>(DistinctSkirt()));
  ForEachChangedField(ToProto(DistinctFacts()), [](const std::string& path, const auto& message) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const v1::JobFacts&>(message);
    const absl::StatusOr<JobFacts> meant = FromProto(changed);
    if (path == "copies[1].copy") return ExpectMalformed(meant.status(), "copies[1].copy");
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(ToProto(*meant), changed));
  });
}

TEST(PlanWire, EachMemberIsTheFieldOfItsName) {
  const auto copy = ProtoOf<v1::Copy>(DistinctCopy());
  EXPECT_EQ(copy.object(), 1);
  EXPECT_EQ(copy.pass(), 4);
  EXPECT_EQ(copy.shift().x_nm(), 2'000);
  EXPECT_EQ(copy.shift().y_nm(), -3'000);
  const auto placed = ProtoOf<v1::PlacedCopy>(DistinctPlaced());
  EXPECT_THAT(placed.footprint_xy_nm(), testing::ElementsAre(4, 5, -6, 7, 8, -9));
  const auto section = ProtoOf<v1::SectionPlan>(DistinctSection(1));
  EXPECT_EQ(section.entry().y_nm(), -3);
  EXPECT_THAT(section.seams_xy_nm(), testing::ElementsAre(4, 5, -6, 7));
  const auto added = ProtoOf<v1::AddedStack>(DistinctStack());
  EXPECT_EQ(added.stack().id(), 7);
  EXPECT_EQ(added.stack().object(), 3);
  EXPECT_EQ(added.lift_nm(), 250'000);
  EXPECT_EQ(ProtoOf<v1::Skirt>(DistinctSkirt()).layers(), 12);
  const v1::CopyName name = ToProto(DistinctName());
  EXPECT_EQ(name.object(), 5);
  EXPECT_EQ(name.copy(), 1);
  EXPECT_EQ(name.copies(), 3);
  const v1::PassFacts pass = ToProto(DistinctFacts()).passes(1);
  EXPECT_EQ(pass.layers_before(), 20);
  EXPECT_EQ(pass.first_layer(), 2);
  EXPECT_EQ(pass.top_before_nm(), 4'000'000);
}

TEST(PlanWire, RefusesObjectsThatNoJobHas) {
  for (const int32_t object : {INT32_MIN, kPlateObject, 1'000, INT32_MAX}) {
    auto copy = ProtoOf<v1::Copy>(DistinctCopy());
    copy.set_object(object);
    ExpectMalformed(FromProto(copy).status(), "object");
    auto placed = ProtoOf<v1::PlacedCopy>(DistinctPlaced());
    placed.set_object(object);
    ExpectMalformed(FromProto(placed).status(), "object");
    auto plan = ProtoOf<v1::LayerPlan>(DistinctLayer());
    plan.mutable_sections(1)->set_stack(object == 1'000 ? 5'000 : object);
    ExpectMalformed(FromProto(plan).status(), "sections[1].stack");
    v1::JobFacts facts = ToProto(DistinctFacts());
    facts.mutable_copies(1)->set_object(object);
    ExpectMalformed(FromProto(facts).status(), "copies[1].object");
  }
}

// G-code rounds to micrometres. With a shift between micrometres a copy would differ from the
// object.
TEST(PlanWire, RefusesShiftsBetweenMicrometres) {
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 999}, {-1'500, 0}}) {
    auto copy = ProtoOf<v1::Copy>(DistinctCopy());
    copy.mutable_shift()->set_x_nm(x);
    copy.mutable_shift()->set_y_nm(y);
    ExpectMalformed(FromProto(copy).status(), "shift");
    auto placed = ProtoOf<v1::PlacedCopy>(DistinctPlaced());
    *placed.mutable_shift() = copy.shift();
    ExpectMalformed(FromProto(placed).status(), "shift");
  }
}

TEST(PlanWire, RefusesWhatDoesNotAddUp) {
  for (const int32_t pass : {-1, 1'000}) {
    auto copy = ProtoOf<v1::Copy>(DistinctCopy());
    copy.set_pass(pass);
    ExpectMalformed(FromProto(copy).status(), "pass");
  }
  auto placed = ProtoOf<v1::PlacedCopy>(DistinctPlaced());
  placed.add_footprint_xy_nm(1);
  ExpectMalformed(FromProto(placed).status(), "footprint_xy_nm");
  auto plan = ProtoOf<v1::LayerPlan>(DistinctLayer());
  plan.mutable_sections(0)->add_seams_xy_nm(1);
  ExpectMalformed(FromProto(plan).status(), "sections[0].seams_xy_nm");
  plan = ProtoOf<v1::LayerPlan>(DistinctLayer());
  plan.mutable_sections(1)->set_stack(3);
  ExpectMalformed(FromProto(plan).status(), "sections");
  plan = ProtoOf<v1::LayerPlan>(DistinctLayer());
  plan.mutable_paths(0)->clear_widths_nm();
  ExpectMalformed(FromProto(plan).status(), "paths[0].widths_nm");
}

TEST(PlanWire, RefusesWhatNoPlanAdds) {
  for (const int64_t lift_nm : {int64_t{-1}, INT64_MAX}) {
    auto added = ProtoOf<v1::AddedStack>(DistinctStack());
    added.set_lift_nm(lift_nm);
    ExpectMalformed(FromProto(added).status(), "lift_nm");
  }
  for (const int32_t layers : {-1, 20'001}) {
    auto skirt = ProtoOf<v1::Skirt>(DistinctSkirt());
    skirt.set_layers(layers);
    ExpectMalformed(FromProto(skirt).status(), "layers");
  }
  auto skirt = ProtoOf<v1::Skirt>(DistinctSkirt());
  skirt.mutable_loops(0)->clear_feature();
  ExpectMalformed(FromProto(skirt).status(), "loops[0].feature");
}

TEST(PlanWire, RefusesSeamsThatNoJobHas) {
  const std::vector<std::pair<std::string, std::function<void(v1::SeamQuality&)>>> spoils = {
      {"loops", [](auto& q) { q.set_loops(79); }},
      {"loops", [](auto& q) { q.set_overhanging(-1); }},
      {"jumps", [](auto& q) { q.set_jumps(81); }},
      {"jumps", [](auto& q) { q.set_jumps(-1); }},
      {"on_corner", [](auto& q) { q.set_on_corner(51); }},
      {"steps_mm", [](auto& q) { q.set_steps_mm(-1); }},
  };
  for (const auto& [field, spoil] : spoils) {
    v1::SeamQuality quality = ToProto(DistinctQuality());
    spoil(quality);
    ExpectMalformed(FromProto(quality).status(), field);
  }
}

TEST(PlanWire, RefusesFactsThatNoJobHas) {
  for (const int32_t count : {-1, 200'001}) {
    v1::JobFacts facts = ToProto(DistinctFacts());
    facts.set_layer_count(count);
    ExpectMalformed(FromProto(facts).status(), "layer_count");
  }
  for (const auto& [copy, copies] : {std::pair{-1, 3}, {3, 3}, {0, 0}, {0, 1'001}}) {
    v1::JobFacts facts = ToProto(DistinctFacts());
    facts.mutable_copies(1)->set_copy(copy);
    facts.mutable_copies(1)->set_copies(copies);
    ExpectMalformed(FromProto(facts).status(), "copies[1].copy");
  }
  const std::vector<std::pair<std::string, std::function<void(v1::PassFacts&)>>> spoils = {
      {"layers_before", [](auto& p) { p.set_layers_before(-1); }},
      {"layers_before", [](auto& p) { p.set_layers_before(200'001); }},
      {"first_layer", [](auto& p) { p.set_first_layer(-1); }},
      {"first_layer", [](auto& p) { p.set_first_layer(20'000); }},
      {"top_before_nm", [](auto& p) { p.set_top_before_nm(-1); }},
      {"top_before_nm", [](auto& p) { p.set_top_before_nm(INT64_MAX); }},
  };
  for (const auto& [field, spoil] : spoils) {
    v1::JobFacts facts = ToProto(DistinctFacts());
    spoil(*facts.mutable_passes(1));
    ExpectMalformed(FromProto(facts).status(), "passes[1]." + field);
  }
  v1::JobFacts names, passes;
  for (int i = 0; i <= 1'000; ++i) {
    *names.add_copies() = ToProto(DistinctName());
    passes.add_passes();
  }
  for (const v1::JobFacts& many : {names, passes}) {
    const absl::Status status = FromProto(many).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
    EXPECT_EQ(DetailOf(status).metadata["got"], "1001");
  }
}

TEST(PlanWire, RefusesPointsBeyondTheWire) {
  const Point far{Coord{1} << 31, 0};
  const auto expect_refused = [](const absl::Status& status, std::string_view field) {
    EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange) << status;
    EXPECT_EQ(DetailOf(status).metadata["field"], field) << status;
  };
  LayerPlan plan = DistinctLayer();
  plan.entry = far;
  v1::LayerPlan proto;
  expect_refused(ToProto(plan, &proto), "entry");
  plan = DistinctLayer();
  plan.sections[1].entry = far;
  expect_refused(ToProto(plan, &proto), "sections[1].entry");
  plan = DistinctLayer();
  plan.sections[1].exit = far;
  expect_refused(ToProto(plan, &proto), "sections[1].exit");
  Copy copy = DistinctCopy();
  copy.shift = far;
  v1::Copy copy_proto;
  EXPECT_EQ(DetailOf(ToProto(copy, &copy_proto)).reason, Reason::kOutOfRange);
}

}  // namespace
}  // namespace slicefarm::plan_wire_test
