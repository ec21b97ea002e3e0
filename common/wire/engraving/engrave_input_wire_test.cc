#include "common/wire/engraving/engrave_input_wire.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::engrave_input_wire_test {
namespace {

EngraveInput Input() {
  EngraveInput input;
  input.settings.texture.anchor = "1,2,3";
  input.settings.lines.normals = NormalKind::kInterpolated;
  input.settings.machine.axes = AxisLayout::kHeadAb;
  input.settings.format = EngraveFormat::kGcode;
  input.solid = {{{0, 0, 0}, {1, 0, 0}, {0, 1e-12, 0}}, {{0, 1, 2}}};
  input.image = std::string("\x89PNG\0", 5);
  input.mask = "mask";
  input.surface = {
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 2.5}}, {{2, 1, 0}}}, {0, 1, 1}, {{0, 0}, {1, 0}, {0, 2}}};
  return input;
}

TEST(EngraveInputWire, Returns) {
  ExpectReturns<v1::EngraveInput>(Input());
  ExpectReturns<v1::EngraveInput>(EngraveInput());
  ExpectReturns<v1::MappedSurface>(Input().surface);
  ExpectReturns<v1::SurfaceInput>(SurfaceInput{Input().solid, false});
}

TEST(EngraveInputWire, ImagesAreNotSentASecondTimeWithTheSettings) {
  EngraveInput input = Input();
  input.settings.texture.image = std::string(10'000, 'A');
  const auto proto = ProtoOf<v1::EngraveInput>(input);
  EXPECT_LT(proto.settings().size(), 10'000U);
  const auto back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, Input());
}

TEST(EngraveInputWire, RefusesWhatDoesNotFit) {
  auto proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_solid()->set_corners(1, 3);
  ExpectMalformed(FromProto(proto).status(), "solid.corners");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_surface()->add_xy_mm(1);
  ExpectMalformed(FromProto(proto).status(), "surface.xy_mm");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_surface()->set_vertex_of(0, -1);
  ExpectMalformed(FromProto(proto).status(), "surface.vertex_of");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_surface()->mutable_mesh()->set_xyz_mm(0, std::numeric_limits<double>::infinity());
  ExpectMalformed(FromProto(proto).status(), "surface.mesh.xyz_mm");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_surface()->mutable_mesh()->set_xyz_mm(3, 1e300);  // its program had "Zinf"
  ExpectMalformed(FromProto(proto).status(), "surface.mesh.xyz_mm");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.mutable_surface()->set_xy_mm(3, -1e300);
  ExpectMalformed(FromProto(proto).status(), "surface.xy_mm");
  proto = ProtoOf<v1::EngraveInput>(Input());
  proto.clear_settings();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::engrave_input_wire_test
