#include "common/wire/layer_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/geometry/text_format.h"
#include "common/base/error.h"
#include "common/wire/every_field.h"
#include "common/wire/path_wire.h"
#include "google/protobuf/util/message_differencer.h"

namespace slicefarm {
namespace {

using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;

constexpr LayerFrame kFrame{3, 800'000, 200'000};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
Path DistinctPath() {
  Path path;
  auto& [feature, object, inset, closed, reversible, tool, height, speed, flow, points, widths] =
      path;
  feature = Feature::kBridgeInfill;
  object = 2;
  inset = 3;
  closed = true;
  reversible = false;
  tool = 4;
  height = 150'000;
  speed = 12.5;
  flow = 0.75;
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

SlicedLayer Sliced() { return {kFrame, {{0, Islands()}, {7, Islands()}}}; }
WalledLayer Walled() {
  return {kFrame,
          {{0, {PlainPath("(0 0, 1 0, 1 1)", true), DistinctPath()}, Islands()}, {1, {}, {}}}};
}
FilledLayer Filled() {
  return {kFrame,
          {{0, {DistinctPath()}, {{true, {PlainPath("(0 0, 9 0)")}}, {false, {}}}}, {1, {}, {}}}};
}
OrderedLayer Ordered() { return {kFrame, {DistinctPath(), PlainPath("(0 0, 1 0, 1 1)")}}; }
LayerPlan Plan() { return {{-1, 2}, {{3, -4}, {5, 6}}}; }

template <typename Proto, typename Model>
Proto ProtoOf(const Model& model) {
  Proto proto;
  const absl::Status status = ToProto(model, &proto);
  EXPECT_TRUE(status.ok()) << status;
  return proto;
}

/// The model returns; and with each field changed alone, the message does, and means something
/// else.
template <typename Proto, typename Model>
void ExpectReturns(const Model& model) {
  const Proto proto = ProtoOf<Proto>(model);
  const absl::StatusOr<Model> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, model);
}

template <typename Proto, typename Model>
void ExpectEveryFieldReturns(const Model& model) {
  int accepted = 0;
  ForEachChangedField(ProtoOf<Proto>(model), [&](const std::string& path, const Message& message) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const Proto&>(message);
    const absl::StatusOr<Model> meant = FromProto(changed);
    if (!meant.ok()) {  // sizes that no longer add up
      EXPECT_THAT(path, testing::HasSubstr("ring"));
      return;
    }
    ++accepted;
    EXPECT_FALSE(*meant == model);
    EXPECT_TRUE(MessageDifferencer::Equals(ProtoOf<Proto>(*meant), changed));
  });
  EXPECT_GT(accepted, 5);
}

TEST(LayerWire, Returns) {
  ExpectReturns<v1::SlicedLayer>(Sliced());
  ExpectReturns<v1::WalledLayer>(Walled());
  ExpectReturns<v1::FilledLayer>(Filled());
  ExpectReturns<v1::OrderedLayer>(Ordered());
  ExpectReturns<v1::LayerPlan>(Plan());
}

TEST(LayerWire, EmptyReturns) {
  ExpectReturns<v1::SlicedLayer>(SlicedLayer{kFrame, {}});
  ExpectReturns<v1::WalledLayer>(WalledLayer{kFrame, {}});
  ExpectReturns<v1::FilledLayer>(FilledLayer{kFrame, {}});
  ExpectReturns<v1::OrderedLayer>(OrderedLayer{kFrame, {}});
  ExpectReturns<v1::LayerPlan>(LayerPlan{});
}

TEST(LayerWire, EveryFieldChangedAloneReturns) {
  ExpectEveryFieldReturns<v1::SlicedLayer>(Sliced());
  ExpectEveryFieldReturns<v1::WalledLayer>(Walled());
  ExpectEveryFieldReturns<v1::FilledLayer>(Filled());
  ExpectEveryFieldReturns<v1::OrderedLayer>(Ordered());
  ExpectEveryFieldReturns<v1::LayerPlan>(Plan());
}

TEST(PathWire, EachMemberIsTheFieldOfItsName) {
  const auto proto = ProtoOf<v1::Path>(DistinctPath());
  EXPECT_EQ(proto.feature(), v1::FEATURE_BRIDGE_INFILL);
  EXPECT_EQ(proto.object(), 2);
  EXPECT_EQ(proto.inset(), 3);
  EXPECT_TRUE(proto.closed());
  EXPECT_TRUE(proto.one_way());
  EXPECT_EQ(proto.tool(), 4);
  EXPECT_EQ(proto.height_nm(), 150'000);
  EXPECT_EQ(proto.speed_mm_s(), 12.5);
  EXPECT_EQ(proto.flow(), 0.75);
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

TEST(PathWire, NoFlowIsOne) {
  v1::Path proto = ProtoOf<v1::Path>(PlainPath("(0 0, 1 0)"));
  EXPECT_FALSE(proto.has_flow());
  EXPECT_EQ(FromProto(proto)->flow, 1);
  proto.set_flow(0);
  EXPECT_EQ(FromProto(proto)->flow, 0);
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
  layer.islands[0].walls[1].points[0].x = Coord{1} << 40;
  v1::WalledLayer proto;
  const absl::Status status = ToProto(layer, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "islands[0].walls[1]");
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
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field) << status;
}

v1::Path& Wall(v1::WalledLayer& layer) { return *layer.mutable_islands(0)->mutable_walls(1); }

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
        Refused{"NegativeObject", [](auto& l) { l.mutable_islands(1)->set_object(-1); },
                "islands[1].object"},
        Refused{"NoFeature", [](auto& l) { Wall(l).clear_feature(); },
                "islands[0].walls[1].feature"},
        Refused{"UnknownFeature", [](auto& l) { Wall(l).set_feature(v1::Feature(99)); },
                "islands[0].walls[1].feature"},
        Refused{"NegativeFeature", [](auto& l) { Wall(l).set_feature(v1::Feature(-5)); },
                "islands[0].walls[1].feature"},
        Refused{"OddCoordinates", [](auto& l) { Wall(l).add_xy_nm(1); },
                "islands[0].walls[1].xy_nm"},
        Refused{"OnePoint", [](auto& l) { Wall(l).mutable_xy_nm()->Truncate(2); },
                "islands[0].walls[1].xy_nm"},
        Refused{"NoWidths", [](auto& l) { Wall(l).clear_widths_nm(); },
                "islands[0].walls[1].widths_nm"},
        Refused{"TwoWidthsForThreePoints",
                [](auto& l) { Wall(l).mutable_widths_nm()->Truncate(2); },
                "islands[0].walls[1].widths_nm"},
        Refused{"NanSpeed", [](auto& l) { Wall(l).set_speed_mm_s(kNan); },
                "islands[0].walls[1].speed_mm_s"},
        Refused{"NegativeSpeed", [](auto& l) { Wall(l).set_speed_mm_s(-1); },
                "islands[0].walls[1].speed_mm_s"},
        Refused{"NanFlow", [](auto& l) { Wall(l).set_flow(kNan); }, "islands[0].walls[1].flow"},
        Refused{"NegativeInset", [](auto& l) { Wall(l).set_inset(-1); },
                "islands[0].walls[1].inset"},
        Refused{"NegativePathObject", [](auto& l) { Wall(l).set_object(-1); },
                "islands[0].walls[1].object"},
        Refused{"NegativeTool", [](auto& l) { Wall(l).set_tool(-1); }, "islands[0].walls[1].tool"},
        Refused{"NegativePathHeight", [](auto& l) { Wall(l).set_height_nm(-1); },
                "islands[0].walls[1].height_nm"},
        Refused{"FillAreaOfOddCoordinates",
                [](auto& l) { l.mutable_islands(0)->mutable_fill_area()->add_xy_nm(1); },
                "islands[0].fill_area.xy_nm"}),
    [](const auto& info) { return info.param.name; });

TEST(LayerWire, RefusesObjectsThatDoNotAscend) {
  auto proto = ProtoOf<v1::SlicedLayer>(Sliced());
  proto.mutable_objects(1)->set_object(0);
  EXPECT_EQ(DetailOf(FromProto(proto).status()).metadata["field"], "objects");
}

TEST(LayerWire, Ranges) {
  EXPECT_EQ(*FromProto(ToProto(LayerRange{3, 9}), 9), (LayerRange{3, 9}));
  for (const auto& [range, count] : std::vector<std::pair<LayerRange, int32_t>>{
           {{0, 0}, 9}, {{-1, 3}, 9}, {{3, 2}, 9}, {{3, 10}, 9}, {{0, 1}, 0}, {{0, 1}, 20'001}}) {
    EXPECT_EQ(DetailOf(FromProto(ToProto(range), count).status()).reason,
              Reason::kRequestMalformed);
  }
}

std::vector<SlicedLayer> Stack(int32_t first, int32_t last) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = first; i < last; ++i) layers.push_back({{i, 1, 1}, {}});
  return layers;
}

TEST(LayerWire, NeighbourhoodSurroundsTheRange) {
  const auto check = [](const std::vector<SlicedLayer>& layers) {
    return CheckNeighbourhood(layers, {4, 6}, 10).ok();
  };
  EXPECT_TRUE(check(Stack(4, 6)));
  EXPECT_TRUE(check(Stack(0, 10)));
  EXPECT_FALSE(check({}));
  EXPECT_FALSE(check(Stack(5, 9)));
  EXPECT_FALSE(check(Stack(2, 5)));
  EXPECT_FALSE(check(Stack(2, 11)));
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

}  // namespace
}  // namespace slicefarm
