#include "common/wire/placed_scene_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::placed_scene_wire_test {
namespace {

PlacedScene Scene() {
  PlacedScene scene;
  PlacedSceneObject& object = scene.objects.emplace_back();
  object.name = "vice";
  object.to_origin = {-1'000'001, 2, Coord{-3'000'000'000}};
  object.shifts = {{5'000, -7'000}, {0, 0}};
  object.parts.resize(2);
  object.parts[0].mesh = {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}};
  object.parts[0].report.name = "jaw";
  object.parts[0].report.volume_mm3 = 12.5;
  object.parts[1].role = PartRole::kModifier;
  scene.objects.emplace_back().name = "b";
  return scene;
}

TEST(PlacedSceneWire, Returns) {
  const auto proto = ProtoOf<v1::PlacedScene>(Scene());
  absl::StatusOr<PlacedScene> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  ASSERT_EQ(MeshSizesOf(proto).size(), 2u);
  EXPECT_EQ(MeshSizesOf(proto)[0].vertices(), 3);
  PutMeshes({Scene().objects[0].parts[0].mesh, {}}, *back);
  ASSERT_EQ(back->objects.size(), 2u);
  const PlacedSceneObject &object = back->objects[0], want = Scene().objects[0];
  EXPECT_EQ(object.name, "vice");
  EXPECT_EQ(object.to_origin, want.to_origin);
  EXPECT_EQ(object.shifts, want.shifts);
  EXPECT_EQ(object.parts[0].mesh, want.parts[0].mesh);
  EXPECT_EQ(object.parts[0].report, want.parts[0].report);
  EXPECT_EQ(object.parts[1].role, PartRole::kModifier);
  // Sizes are read from the meshes, which are sent separately.
  auto without = proto;
  without.mutable_objects(0)->mutable_parts(0)->mutable_size()->clear_vertices();
  without.mutable_objects(0)->mutable_parts(0)->mutable_size()->clear_triangles();
  ExpectEveryChangeReturns<v1::PlacedScene, PlacedScene>(without, {}, {"size"});
}

TEST(PlacedSceneWire, RefusesWhatIsNoScene) {
  auto proto = ProtoOf<v1::PlacedScene>(Scene());
  proto.mutable_objects(0)->add_to_origin_nm(1);
  ExpectMalformed(FromProto(proto).status(), "objects[0].to_origin_nm");
  proto = ProtoOf<v1::PlacedScene>(Scene());
  proto.mutable_objects(0)->mutable_parts(1)->clear_role();
  ExpectMalformed(FromProto(proto).status(), "objects[0].parts[1].role");
  proto = ProtoOf<v1::PlacedScene>(Scene());
  while (proto.objects_size() <= 1'000) proto.add_objects();
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::placed_scene_wire_test
