#include "common/wire/support/mesh_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"
#include "google/protobuf/util/message_differencer.h"
#include "tests/support/every_field.h"

namespace slicefarm::mesh_wire_test {
namespace {

using google::protobuf::Message;
using google::protobuf::util::MessageDifferencer;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The structured bindings name every member. A new member does not compile until it is added here,
// and thereby to the message.
Placement DistinctPlacement() {
  Placement placement;
  auto& [unit, scale, rotate, centers] = placement;
  unit = 25.4;
  scale = {1.5, 2, 2.5};
  rotate = {10, -20, 30};
  centers = {{1, -2}, {-2'147'483'648, 2'147'483'647}};
  return placement;
}

MeshReport DistinctReport() {
  MeshReport report;
  auto& [name, triangles, vertices, bodies, open_edges, non_manifold_edges, flipped_faces,
         degenerate_faces, repeated_faces, volume, min, max, closed, dropped, gap, length, off_bed,
         overlapping, cracks] = report;
  name = "part";
  triangles = 1;
  vertices = 2;
  bodies = 3;
  open_edges = 4;
  non_manifold_edges = 5;
  flipped_faces = 6;
  degenerate_faces = 7;
  repeated_faces = 21;
  volume = -8;
  min = {-9, -10, -11};
  max = {12, 13, 14};
  closed = 15;
  dropped = 16;
  gap = 17;
  length = 18;
  off_bed = 22;
  overlapping = 19;
  cracks = 20;
  return report;
}

v1::Placement Proto(const Placement& placement) {
  v1::Placement proto;
  EXPECT_TRUE(ToProto(placement, &proto).ok());
  return proto;
}

TEST(MeshWire, FormatsReturn) {
  for (const MeshFormat format : {MeshFormat::kUnknown, MeshFormat::kStl, MeshFormat::kObj,
                                  MeshFormat::kPly, MeshFormat::k3mf}) {
    EXPECT_EQ(*FromProto(ToProto(format)), format);
  }
  EXPECT_FALSE(FromProto(v1::MeshFormat(9)).ok());
}

TEST(MeshWire, PlacementReturns) {
  for (const Placement& placement : {Placement{}, DistinctPlacement()}) {
    EXPECT_EQ(*FromProto(Proto(placement)), placement);
  }
  ForEachChangedField(Proto(DistinctPlacement()), [](const std::string& path, const Message& m) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const v1::Placement&>(m);
    const absl::StatusOr<Placement> meant = FromProto(changed);
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_FALSE(*meant == DistinctPlacement());
    EXPECT_TRUE(MessageDifferencer::Equals(Proto(*meant), changed));
  });
}

TEST(MeshWire, AnEmptyPlacementIsTheUsualOne) {
  EXPECT_EQ(*FromProto(v1::Placement()), Placement{});
}

TEST(MeshWire, OneScaleGoesForAllAxes) {
  v1::Placement proto;
  proto.add_scale(2);
  EXPECT_THAT(FromProto(proto)->scale, testing::ElementsAre(2, 2, 2));
}

TEST(MeshWire, ReportReturns) {
  const v1::MeshReport proto = ToProto(DistinctReport());
  EXPECT_EQ(*FromProto(proto), DistinctReport());
  EXPECT_EQ(proto.open_edges(), 4);
  EXPECT_EQ(proto.non_manifold_edges(), 5);
  EXPECT_EQ(proto.flipped_faces(), 6);
  EXPECT_EQ(proto.degenerate_faces(), 7);
  EXPECT_EQ(proto.repeated_faces(), 21);
  EXPECT_EQ(proto.open_loops_closed(), 15);
  EXPECT_EQ(proto.open_loops_dropped(), 16);
  ForEachChangedField(proto, [](const std::string& path, const Message& m) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const v1::MeshReport&>(m);
    const absl::StatusOr<MeshReport> meant = FromProto(changed);
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_FALSE(*meant == DistinctReport());
    EXPECT_TRUE(MessageDifferencer::Equals(ToProto(*meant), changed));
  });
}

OrientationAdvice DistinctAdvice() {
  OrientationAdvice advice;
  auto& [object, rotate_deg, asked, advised] = advice;
  auto& [contact, overhang, height, stable] = asked;
  object = "lid";
  rotate_deg = {4, -5, 6};
  contact = 7;
  overhang = 8;
  height = 9;
  stable = false;
  advised = {10, 11, 12, true};
  return advice;
}

TEST(MeshWire, OrientationAdviceReturnsWithEveryFieldChangedAlone) {
  const v1::OrientationAdvice proto = ToProto(DistinctAdvice());
  EXPECT_EQ(*FromProto(proto), DistinctAdvice());
  EXPECT_EQ(proto.asked().overhang_mm2(), 8);
  ForEachChangedField(proto, [](const std::string& path, const auto& message) {
    SCOPED_TRACE(path);
    const auto& changed = dynamic_cast<const v1::OrientationAdvice&>(message);
    const absl::StatusOr<OrientationAdvice> meant = FromProto(changed);
    ASSERT_TRUE(meant.ok()) << meant.status();
    EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(ToProto(*meant), changed));
  });
}

TEST(MeshWire, RefusesAdviceThatNoOrientationHas) {
  v1::OrientationAdvice proto = ToProto(DistinctAdvice());
  proto.add_rotate_deg(1);
  EXPECT_FALSE(FromProto(proto).ok());
  proto = ToProto(DistinctAdvice());
  proto.mutable_advised()->set_height_mm(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(FromProto(proto).ok());
}

TEST(MeshWire, ThumbnailReturns) {
  const Thumbnail thumbnail{32, 33, std::string("\x89PNG\0", 5), PictureFormat::kQoi,
                            PictureRole::kPick};
  EXPECT_EQ(*FromProto(ToProto(thumbnail)), thumbnail);
  EXPECT_FALSE(FromProto(v1::Thumbnail()).ok());
}

struct Refused {
  std::string name;
  std::function<void(v1::Placement&)> spoil;
  std::string field;
};

class PlacementWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(PlacementWireRefuses, NamingTheField) {
  v1::Placement proto = Proto(DistinctPlacement());
  GetParam().spoil(proto);
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field) << status;
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, PlacementWireRefuses,
    testing::Values(Refused{"NanUnit", [](auto& p) { p.set_unit_mm(kNan); }, "unit_mm"},
                    Refused{"NegativeUnit", [](auto& p) { p.set_unit_mm(-1); }, "unit_mm"},
                    Refused{"TwoScales", [](auto& p) { p.mutable_scale()->Truncate(2); }, "scale"},
                    Refused{"NoScale", [](auto& p) { p.set_scale(1, 0); }, "scale"},
                    Refused{"NanScale", [](auto& p) { p.set_scale(2, kNan); }, "scale"},
                    Refused{"TwoAngles", [](auto& p) { p.mutable_rotate_deg()->Truncate(2); },
                            "rotate_deg"},
                    Refused{"NanAngle", [](auto& p) { p.set_rotate_deg(0, kNan); }, "rotate_deg"}),
    [](const auto& info) { return info.param.name; });

TEST(MeshWire, RefusesTooManyCopies) {
  v1::Placement proto;
  for (int i = 0; i < 1'001; ++i) proto.add_centers();
  const absl::Status status = FromProto(proto).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
}

TEST(MeshWire, RefusesCentersBeyondTheWire) {
  Placement placement;
  placement.centers = {{0, 0}, {Coord{1} << 31, 0}};
  v1::Placement proto;
  const absl::Status status = ToProto(placement, &proto);
  EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(status).metadata["field"], "centers[1]");
}

TEST(MeshWire, RefusesReportsWithoutABox) {
  v1::MeshReport proto = ToProto(DistinctReport());
  proto.clear_min_mm();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).metadata["field"], "min_mm");
}

}  // namespace
}  // namespace slicefarm::mesh_wire_test
