#include "common/wire/layers/layer_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/wire/layers/path_wire.h"
#include "common/wire/layers/region_wire.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::layer_wire_test {
namespace {

constexpr LayerFrame kFrame{3, 800'000, 200'000};

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
Path DistinctPath() {
  Path path;
  auto& [feature, settings, inset, ring, closed, reversible, tool, points, widths] = path;
  feature = Feature::kBridgeInfill;
  settings = 2;
  inset = 3;
  ring = 6;
  closed = true;
  reversible = false;
  tool = 4;
  points = {{1, 2}, {-3, 4}, {5, -6}};
  widths = {450'000, 0, 4'294'967'295};
  return path;
}

Path PlainPath(const char* text, bool closed = false) {
  Path path;
  path.closed = closed;
  path.points = MakeLineOrDie(text);
  path.widths_nm = {450'000};
  return path;
}

const MultiPolygon& Islands() {
  static const MultiPolygon islands = MakePolygonsOrDie(
      "(20 0, 30 0, 30 10) ; (0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) (5 5, 6 5, 6 6)");
  return islands;
}

const Stack kRaftStack(9, kPlateObject, StackKind::kRaft);

ObjectSection DistinctSection(Stack of) {
  ObjectSection section;
  auto& [stack, layer, layer_count, height, regions, whole, z, marks, hollow, surface] = section;
  stack = of;
  layer = 5;
  layer_count = 9;
  height = 150'000;
  regions = {{Role::kPart, 1, 2, Islands()}, {Role::kRaft, 3, 4, {}}};
  whole = Islands();
  z = 950'000;
  hollow = true;
  surface = {{{Point{1, 2}, {-3, 4}, {5, 6}}, {-7, 8, 9}},
             {{Point{7, 0}, {8, 0}, {7, 9}}, {1, 2, 3}}};
  marks = {{PartRole::kSupportBlocker, {Islands()[0]}}, {PartRole::kSeamEnforcer, {Islands()[1]}}};
  return section;
}

WalledSection WalledOf(Stack of, std::vector<WalledIsland> with) {
  WalledSection section;
  auto& [stack, layer, height, islands] = section;
  stack = of;
  layer = 6;
  height = 250'000;
  islands = std::move(with);
  return section;
}

FilledSection FilledOf(Stack of, std::vector<FilledIsland> with) {
  FilledSection section;
  auto& [stack, layer, height, islands, uses] = section;
  stack = of;
  layer = 6;
  height = 250'000;
  islands = std::move(with);
  uses = {{.settings = 1, .pattern = FillPattern::kGrid, .area_mm2 = 2}, {}};
  return section;
}

SlicedLayer Sliced() { return {kFrame, {DistinctSection(7), DistinctSection(kRaftStack)}}; }
WalledLayer Walled() {
  const WalledIsland island{{PlainPath("(0 0, 1 0, 1 1)", true), DistinctPath()},
                            {{Role::kPart, 1, 2, Islands()}, {Role::kBrim, 3, 4, Islands()}},
                            Islands().back()};
  return {kFrame, {WalledOf(1, {{{}, {}}}), WalledOf(3, {island})}, 8};
}
FilledLayer Filled() {
  const FilledIsland island{
      {DistinctPath()}, {{true, {PlainPath("(0 0, 9 0)")}}, {false, {}}}, Islands().back()};
  return {kFrame, {FilledOf(0, {island, {}}), FilledOf(2, {})}};
}
OrderedLayer Ordered() {
  PathBlock first;
  auto& [stack, layer, height, paths, travels, exit_travel, below, above_supports, curled, spiral,
         surface] = first;
  stack = kRaftStack;
  layer = 2;
  height = 150'000;
  paths = {DistinctPath()};
  Travel travel;
  auto& [hidden, corners, over_wall] = travel;
  hidden = over_wall = true;
  corners = {{1, 2}, {-3, 4}};
  travels = {travel};
  auto& [to, route] = exit_travel.emplace();
  to = {5, -6};
  route = {true, {{7, 8}}};
  below = *ParseMultiPolygon("(0 0, 9 0, 9 9)");
  above_supports = *ParseMultiPolygon("(1 1, 3 1, 3 3)");
  curled = *ParseMultiPolygon("(2 1, 3 1, 3 2)");
  spiral = {{1, 2}, Point{3, 4}, true, false};
  surface = {{{Point{1, 2}, {-3, 4}, {5, 6}}, {-7, 8, 9}}};
  BlockVisit visit;
  auto& [block, copy, pass, shift, turns] = visit;
  block = 1;
  copy = 11;
  pass = 12;
  shift = {-13'000, 14'000};
  turns = {{9, 8}, {-7, 6}};
  return {
      kFrame, {first, {4, 3, 200'000, {PlainPath("(0 0, 1 0, 1 1)")}}}, {{}, visit}, true, true};
}

template <typename Proto, typename Model>
void ExpectEveryFieldReturns(const Model& model) {
  // Changes that make sizes inconsistent, or a stack not part of its object, are refused.
  ExpectEveryChangeReturns<Proto, Model>(ProtoOf<Proto>(model),
                                         {"ring_sizes", "rings_per_island", "stack"});
}

TEST(LayerWire, Returns) {
  ExpectReturns<v1::SlicedLayer>(Sliced());
  ExpectReturns<v1::WalledLayer>(Walled());
  ExpectReturns<v1::FilledLayer>(Filled());
  ExpectReturns<v1::OrderedLayer>(Ordered());
}

TEST(LayerWire, EmptyReturns) {
  ExpectReturns<v1::SlicedLayer>(SlicedLayer{kFrame, {}});
  ExpectReturns<v1::WalledLayer>(WalledLayer{kFrame, {}});
  ExpectReturns<v1::FilledLayer>(FilledLayer{kFrame, {}});
  ExpectReturns<v1::OrderedLayer>(OrderedLayer{kFrame, {}, {}});
}

TEST(LayerWire, EveryFieldChangedAloneReturns) {
  ExpectEveryFieldReturns<v1::SlicedLayer>(Sliced());
  ExpectEveryFieldReturns<v1::WalledLayer>(Walled());
  ExpectEveryFieldReturns<v1::FilledLayer>(Filled());
  ExpectEveryFieldReturns<v1::OrderedLayer>(Ordered());
}

// A single region is its own union. Without this rule most layers would be twice as long.
TEST(LayerWire, NoWholeIsNotSent) {
  ObjectSection section = DistinctSection(0);
  section.whole.clear();
  const auto proto = ProtoOf<v1::ObjectSection>(section);
  EXPECT_FALSE(proto.has_whole());
  EXPECT_EQ(*FromProto(proto), section);
}

// Finds fields that are swapped in both directions, which no round trip finds.
TEST(LayerWire, EachMemberIsTheFieldOfItsName) {
  const auto section = ProtoOf<v1::ObjectSection>(DistinctSection(kRaftStack));
  EXPECT_EQ(section.stack().id(), 9);
  EXPECT_EQ(section.stack().object(), -1);
  EXPECT_EQ(section.stack().kind(), v1::STACK_KIND_RAFT);
  EXPECT_EQ(section.marks(0).role(), v1::PART_ROLE_SUPPORT_BLOCKER);
  EXPECT_EQ(section.layer(), 5);
  EXPECT_EQ(section.layer_count(), 9);
  EXPECT_EQ(section.height_nm(), 150'000);
  const auto walled = ProtoOf<v1::WalledLayer>(Walled());
  EXPECT_EQ(walled.sections(1).stack().id(), 3);
  EXPECT_EQ(walled.sections(1).layer(), 6);
  EXPECT_EQ(walled.sections(1).height_nm(), 250'000);
  EXPECT_EQ(walled.plain_islands(), 8);
  const auto ordered = ProtoOf<v1::OrderedLayer>(Ordered());
  EXPECT_EQ(ordered.blocks(0).stack().id(), 9);
  EXPECT_EQ(ordered.blocks(0).layer(), 2);
  EXPECT_EQ(ordered.visits(1).block(), 1);
  EXPECT_EQ(ordered.visits(1).copy(), 11);
  EXPECT_EQ(ordered.visits(1).pass(), 12);
  EXPECT_EQ(ordered.visits(1).shift().x_nm(), -13'000);
}

TEST(PathWire, EachMemberIsTheFieldOfItsName) {
  const auto proto = ProtoOf<v1::Path>(DistinctPath());
  EXPECT_EQ(proto.feature(), v1::FEATURE_BRIDGE_INFILL);
  EXPECT_EQ(proto.settings(), 2);
  EXPECT_EQ(proto.inset(), 3);
  EXPECT_TRUE(proto.closed());
  EXPECT_TRUE(proto.one_way());
  EXPECT_EQ(proto.tool(), 4);
  EXPECT_EQ(proto.ring(), 6);
  EXPECT_THAT(proto.xy_nm(), testing::ElementsAre(1, 2, -3, 4, 5, -6));
  EXPECT_THAT(proto.widths_nm(), testing::ElementsAre(450'000, 0, 4'294'967'295));
}

TEST(PathWire, EveryFeatureReturns) {
  for (int i = 0; i < kFeatureCount; ++i) {
    Path path = PlainPath("(0 0, 1 0)");
    path.feature = static_cast<Feature>(i);
    ExpectReturns<v1::Path>(path);
  }
}

TEST(PathWire, NoRingIsNotTheFirstOne) {
  v1::Path proto = ProtoOf<v1::Path>(PlainPath("(0 0, 1 0)"));
  EXPECT_FALSE(proto.has_ring());
  EXPECT_EQ(FromProto(proto)->ring, -1);
  proto.set_ring(0);
  EXPECT_EQ(FromProto(proto)->ring, 0);
}

TEST(PathWire, RefusesWidthsBeyondTheWire) {
  for (const Coord width : {Coord{-1}, Coord{1} << 32}) {
    Path path = PlainPath("(0 0, 1 0)");
    path.widths_nm = {width};
    v1::Path proto;
    EXPECT_EQ(DetailOf(ToProto(path, &proto)).reason, Reason::kOutOfRange);
  }
}

TEST(LayerWire, NamesThePathThatIsBeyondTheWire) {
  WalledLayer layer = Walled();
  layer.sections[1].islands[0].walls[1].points[0].x = Coord{1} << 40;
  v1::WalledLayer proto;
  const absl::Status status = ToProto(layer, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "sections[1].islands[0].walls[1]");
}

struct Refused {
  std::string name;
  std::function<void(v1::WalledLayer&)> spoil;
  std::string field;
};

class LayerWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(LayerWireRefuses, NamingTheField) {
  auto proto = ProtoOf<v1::WalledLayer>(Walled());
  GetParam().spoil(proto);
  ExpectMalformed(FromProto(proto).status(), GetParam().field);
}

v1::WalledSection& Section(v1::WalledLayer& layer) { return *layer.mutable_sections(1); }
v1::WalledIsland& Island(v1::WalledLayer& layer) { return *Section(layer).mutable_islands(0); }
v1::Path& Wall(v1::WalledLayer& layer) { return *Island(layer).mutable_walls(1); }

INSTANTIATE_TEST_SUITE_P(
    Layers, LayerWireRefuses,
    testing::Values(
        Refused{"NoFrame", [](auto& l) { l.clear_frame(); }, "frame.print_z_nm"},
        Refused{"NegativeIndex", [](auto& l) { l.mutable_frame()->set_index(-1); }, "frame.index"},
        Refused{"HugeIndex", [](auto& l) { l.mutable_frame()->set_index(20'000); }, "frame.index"},
        Refused{"NoHeight", [](auto& l) { l.mutable_frame()->clear_height_nm(); },
                "frame.height_nm"},
        Refused{"HugeHeight", [](auto& l) { l.mutable_frame()->set_height_nm(INT64_MAX); },
                "frame.height_nm"},
        Refused{"NegativeObject", [](auto& l) { Section(l).mutable_stack()->set_object(-1); },
                "sections[1].stack.object"},
        Refused{"HugeObject", [](auto& l) { Section(l).mutable_stack()->set_object(1'000); },
                "sections[1].stack.object"},
        Refused{"NegativeStack", [](auto& l) { Section(l).mutable_stack()->set_id(-1); },
                "sections[1].stack.id"},
        Refused{"HugeStack", [](auto& l) { Section(l).mutable_stack()->set_id(5'000); },
                "sections[1].stack.id"},
        Refused{"APartThatIsNotItsObject", [](auto& l) { Section(l).mutable_stack()->set_id(4); },
                "sections[1].stack.id"},
        Refused{"NoKind", [](auto& l) { Section(l).mutable_stack()->clear_kind(); },
                "sections[1].stack.kind"},
        Refused{"NegativeLayer", [](auto& l) { Section(l).set_layer(-1); }, "sections[1].layer"},
        Refused{"HugeLayer", [](auto& l) { Section(l).set_layer(20'000); }, "sections[1].layer"},
        Refused{"NoSectionHeight", [](auto& l) { Section(l).clear_height_nm(); },
                "sections[1].height_nm"},
        Refused{"StacksThatDoNotAscend",
                [](auto& l) { *l.mutable_sections(0)->mutable_stack() = Section(l).stack(); },
                "sections"},
        Refused{"NegativePlainIslands", [](auto& l) { l.set_plain_islands(-1); }, "plain_islands"},
        Refused{"NoFeature", [](auto& l) { Wall(l).clear_feature(); },
                "sections[1].islands[0].walls[1].feature"},
        Refused{"UnknownFeature", [](auto& l) { Wall(l).set_feature(v1::Feature(99)); },
                "sections[1].islands[0].walls[1].feature"},
        Refused{"NegativeFeature", [](auto& l) { Wall(l).set_feature(v1::Feature(-5)); },
                "sections[1].islands[0].walls[1].feature"},
        Refused{"OddCoordinates", [](auto& l) { Wall(l).add_xy_nm(1); },
                "sections[1].islands[0].walls[1].xy_nm"},
        Refused{"OnePoint", [](auto& l) { Wall(l).mutable_xy_nm()->Truncate(2); },
                "sections[1].islands[0].walls[1].xy_nm"},
        Refused{"NoWidths", [](auto& l) { Wall(l).clear_widths_nm(); },
                "sections[1].islands[0].walls[1].widths_nm"},
        Refused{"TwoWidthsForThreePoints",
                [](auto& l) { Wall(l).mutable_widths_nm()->Truncate(2); },
                "sections[1].islands[0].walls[1].widths_nm"},
        Refused{"NegativeInset", [](auto& l) { Wall(l).set_inset(-1); },
                "sections[1].islands[0].walls[1].inset"},
        Refused{"NegativeSettings", [](auto& l) { Wall(l).set_settings(-1); },
                "sections[1].islands[0].walls[1].settings"},
        Refused{"NegativeRing", [](auto& l) { Wall(l).set_ring(-1); },
                "sections[1].islands[0].walls[1].ring"},
        Refused{"NegativeTool", [](auto& l) { Wall(l).set_tool(-1); },
                "sections[1].islands[0].walls[1].tool"},
        Refused{"FillAreaOfOddCoordinates",
                [](auto& l) { Island(l).mutable_fill_areas(1)->mutable_area()->add_xy_nm(1); },
                "sections[1].islands[0].fill_areas[1].area.xy_nm"},
        Refused{"FillAreaWithoutRole",
                [](auto& l) { Island(l).mutable_fill_areas(1)->clear_role(); },
                "sections[1].islands[0].fill_areas[1].role"}),
    [](const auto& info) { return info.param.name; });

TEST(LayerWire, RefusesStacksThatDoNotAscend) {
  for (const Stack stack : {Stack(0), Stack(7), Stack(6, 0, StackKind::kSupport)}) {
    const SlicedLayer layer{kFrame, {DistinctSection(7), DistinctSection(stack)}};
    ExpectMalformed(FromProto(ProtoOf<v1::SlicedLayer>(layer)).status(), "sections");
  }
}

TEST(LayerWire, TheSkirtIsNoOtherStack) {
  auto proto = ProtoOf<v1::OrderedLayer>(Ordered());
  ToProto(kSkirtStack, proto.mutable_blocks(0)->mutable_stack());
  const auto layer = FromProto(proto);
  ASSERT_TRUE(layer.ok()) << layer.status();
  EXPECT_EQ(layer->blocks[0].stack, kSkirtStack);
  proto.mutable_blocks(0)->mutable_stack()->set_object(0);
  ExpectMalformed(FromProto(proto).status(), "blocks[0].stack");
}

TEST(LayerWire, ASectionIsOneOfTheObjectsLayers) {
  for (const int32_t count : {INT32_MIN, -1, 0, 5, 20'001}) {
    auto proto = ProtoOf<v1::SlicedLayer>(Sliced());
    proto.mutable_sections(1)->set_layer_count(count);
    ExpectMalformed(FromProto(proto).status(), "sections[1].layer_count");
  }
}

TEST(LayerWire, RefusesRegionsAndWholesThatDoNotAddUp) {
  auto region = ProtoOf<v1::SlicedLayer>(Sliced());
  region.mutable_sections(1)->mutable_regions(0)->mutable_outlines()->add_xy_nm(1);
  ExpectMalformed(FromProto(region).status(), "sections[1].regions[0].outlines.xy_nm");
  auto whole = ProtoOf<v1::SlicedLayer>(Sliced());
  whole.mutable_sections(1)->mutable_whole()->add_ring_sizes(3);
  ExpectMalformed(FromProto(whole).status(), "sections[1].whole.ring_sizes");
}

TEST(LayerWire, RefusesVisitsThatNoJobHas) {
  const std::vector<std::pair<std::string, std::function<void(v1::BlockVisit&)>>> spoils = {
      {"block", [](auto& v) { v.set_block(-1); }},
      {"copy", [](auto& v) { v.set_copy(-2); }},
      {"copy", [](auto& v) { v.set_copy(1'000); }},
      {"pass", [](auto& v) { v.set_pass(-1); }},
  };
  for (const auto& [field, spoil] : spoils) {
    auto proto = ProtoOf<v1::OrderedLayer>(Ordered());
    spoil(*proto.mutable_visits(1));
    ExpectMalformed(FromProto(proto).status(), "visits[1]." + field);
  }
  auto proto = ProtoOf<v1::OrderedLayer>(Ordered());
  proto.mutable_blocks(1)->mutable_stack()->set_object(-2);
  ExpectMalformed(FromProto(proto).status(), "blocks[1].stack.object");
}

TEST(LayerWire, RefusesTravelsThatAreNotOneForEachPath) {
  auto proto = ProtoOf<v1::OrderedLayer>(Ordered());
  proto.mutable_blocks(0)->add_travels();
  ExpectMalformed(FromProto(proto).status(), "blocks[0].travels");
  proto = ProtoOf<v1::OrderedLayer>(Ordered());
  proto.mutable_blocks(0)->mutable_travels(0)->add_corners_xy_nm(1);
  ExpectMalformed(FromProto(proto).status(), "blocks[0].travels[0].corners_xy_nm");
  proto = ProtoOf<v1::OrderedLayer>(Ordered());
  proto.mutable_blocks(0)->mutable_exit_travel()->mutable_travel()->add_corners_xy_nm(1);
  ExpectMalformed(FromProto(proto).status(), "blocks[0].exit_travel.travel.corners_xy_nm");
}

TEST(LayerWire, RefusesAnOutlineOfTwoIslands) {
  auto walled = ProtoOf<v1::WalledLayer>(Walled());
  v1::WalledIsland& island = *walled.mutable_sections(1)->mutable_islands(0);
  *island.mutable_outline() = island.fill_areas(0).area();
  ExpectMalformed(FromProto(walled).status(), "sections[1].islands[0].outline");
}

TEST(LayerWire, Ranges) {
  EXPECT_EQ(*FromProto(ToProto(LayerRange{3, 9})), (LayerRange{3, 9}));
  EXPECT_EQ(*FromProto(ToProto(LayerRange{0, 20'000})), (LayerRange{0, 20'000}));
  for (const LayerRange range : {LayerRange{0, 0}, {-1, 3}, {3, 2}, {3, 3}, {0, 20'001}})
    ExpectMalformed(FromProto(ToProto(range)).status(), "range");
}

std::vector<SlicedLayer> Stack(int32_t first, int32_t last) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = first; i < last; ++i) layers.push_back({{i, 1, 1}, {}});
  return layers;
}

TEST(LayerWire, NeighbourhoodSurroundsTheRange) {
  const auto check = [](const std::vector<SlicedLayer>& layers) {
    return CheckNeighbourhood(layers, {4, 6}).ok();
  };
  EXPECT_TRUE(check(Stack(4, 6)));
  EXPECT_TRUE(check(Stack(0, 10)));
  EXPECT_FALSE(check({}));
  EXPECT_FALSE(check(Stack(5, 9)));
  EXPECT_FALSE(check(Stack(2, 5)));
  std::vector<SlicedLayer> gap = Stack(2, 9);
  gap.erase(gap.begin() + 1);
  EXPECT_FALSE(check(gap));
}

TEST(LayerWire, ALayerThatDoesNotFollowIsRefusedAtOnce) {
  std::vector<SlicedLayer> layers;
  EXPECT_TRUE(AppendNext<SlicedLayer>(Stack(4, 5)[0], &layers).ok());
  EXPECT_TRUE(AppendNext<SlicedLayer>(Stack(5, 6)[0], &layers).ok());
  EXPECT_FALSE(AppendNext<SlicedLayer>(Stack(5, 6)[0], &layers).ok());
}

TEST(LayerWire, LayersOfTheRangeAreOneEach) {
  const auto check = [](const std::vector<SlicedLayer>& layers) {
    return CheckLayersOfRange(layers, {4, 6}).ok();
  };
  EXPECT_TRUE(check(Stack(4, 6)));
  EXPECT_FALSE(check(Stack(4, 7)));
  EXPECT_FALSE(check(Stack(5, 7)));
  EXPECT_FALSE(check({}));
}

TEST(LayerWire, ProgramsOfTheRangeAreByLayerThenPass) {
  const auto check = [](const std::vector<std::pair<int32_t, int32_t>>& layers_and_passes) {
    std::vector<LayerProgram> programs;
    for (const auto& [layer, pass] : layers_and_passes) {
      programs.emplace_back().frame.index = layer;
      programs.back().pass = pass;
    }
    return CheckProgramsOfRange(programs, {4, 6}).ok();
  };
  EXPECT_TRUE(check({{4, 0}, {5, 0}}));
  EXPECT_TRUE(check({{4, 0}, {4, 1}, {4, 7}, {5, 3}}));
  EXPECT_FALSE(check({}));
  EXPECT_FALSE(check({{4, 0}})) << "none of the last layer";
  EXPECT_FALSE(check({{5, 0}})) << "none of the first layer";
  EXPECT_FALSE(check({{3, 0}, {4, 0}, {5, 0}}));
  EXPECT_FALSE(check({{4, 0}, {5, 0}, {6, 0}}));
  EXPECT_FALSE(check({{4, 0}, {4, 0}, {5, 0}})) << "a pass twice";
  EXPECT_FALSE(check({{4, 1}, {4, 0}, {5, 0}})) << "passes that do not ascend";
  EXPECT_FALSE(check({{4, 0}, {5, 0}, {4, 1}})) << "back to a layer";
}

}  // namespace
}  // namespace slicefarm::layer_wire_test
