#include "common/wire/scene_wire.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"

namespace slicefarm::scene_wire_test {
namespace {

using Objects = google::protobuf::RepeatedPtrField<v1::Object>;

/// Returns a scene with a value different from the default in every field.
SubmittedScene RichScene() {
  SubmittedScene scene;
  scene.meshes = {{Sha256Hex("a"), "bracket", MeshFormat::k3mf},
                  {Sha256Hex("b"), "bracket", MeshFormat::kStl}};
  SceneObject object;
  object.name = "bracket";
  object.settings = {{"perimeters", "4", Source::kProfile}};
  Part body{"body", {0, 2, 12, 24}, PartRole::kSolid, Transform::Identity(), {}};
  body.to_object(1, 3) = -0.1;
  Part modifier{"denser",
                {1, kOnlyMesh, 0, -1},
                PartRole::kModifier,
                Transform::Identity(),
                {{"fill_density", "80%", Source::kRequest}}};
  object.parts = {body, modifier};
  object.ranges = {{1.5, 2.5, {{"layer_height", "0.1", Source::kProfile}}}};
  Instance placed;
  placed.to_plate(0, 3) = 1.0 / 3;
  Instance free;
  free.placed = false;
  free.by_middle = true;
  Instance by_middle;
  by_middle.by_middle = true;
  object.instances = {placed, free, by_middle};
  scene.objects = {object};
  return scene;
}

Objects ProtoOf(const SubmittedScene& scene) {
  Objects proto;
  for (const SceneObject& object : scene.objects) ToProto(object, scene.meshes, proto.Add());
  return proto;
}

TEST(SceneWire, ComesBackAsItWas) {
  const SubmittedScene scene = RichScene();
  const auto back = FromProto(ProtoOf(scene));
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, scene);
}

TEST(SceneWire, CopiesThatAreNotPrintedStayBehind) {
  SubmittedScene scene = RichScene();
  scene.objects[0].instances[1].printable = false;
  EXPECT_EQ(FromProto(ProtoOf(scene))->objects[0].instances.size(), 2);
}

TEST(SceneWire, AnObjectMayBeAMeshAlone) {
  Objects proto;
  v1::Object& object = *proto.Add();
  object.set_name("a.stl");
  object.set_mesh_sha256(Sha256Hex("a"));
  object.set_copies(3);
  *proto.Add() = object;
  const auto scene = FromProto(proto);
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->meshes.size(), 1);
  ASSERT_EQ(scene->objects.size(), 2);
  EXPECT_EQ(scene->objects[1], ObjectOfFile("a.stl", 0, {}, 3));
}

TEST(SceneWire, WhatIsNotGivenIsAsUsual) {
  Objects proto;
  v1::Part& part = *proto.Add()->add_parts();
  part.mutable_mesh()->set_sha256(Sha256Hex("a"));
  const auto scene = FromProto(proto);
  ASSERT_TRUE(scene.ok()) << scene.status();
  const SceneObject& object = scene->objects[0];
  EXPECT_EQ(object.parts[0].mesh, (MeshRef{0, kOnlyMesh, 0, -1}));
  EXPECT_EQ(object.parts[0].role, PartRole::kSolid);
  EXPECT_EQ(object.parts[0].to_object, Transform(Transform::Identity()));
  ASSERT_EQ(object.instances.size(), 1);
  EXPECT_FALSE(object.instances[0].placed);
}

struct Refused {
  std::string name;
  std::function<void(v1::Object&)> change;
  std::string field;
};

class SceneWireRefuses : public testing::TestWithParam<Refused> {};

TEST_P(SceneWireRefuses, NamingTheField) {
  Objects proto = ProtoOf(RichScene());
  GetParam().change(proto[0]);
  const absl::Status status = FromProto(proto).status();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata["field"], GetParam().field);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    All, SceneWireRefuses,
    testing::Values(
        Refused{"NoDigest", [](auto& o) { o.mutable_parts(1)->mutable_mesh()->set_sha256("x"); },
                "objects[0].parts[1].mesh.sha256"},
        Refused{"NegativeMesh", [](auto& o) { o.mutable_parts(0)->mutable_mesh()->set_mesh(-2); },
                "objects[0].parts[0].mesh"},
        Refused{"NegativeTriangle",
                [](auto& o) { o.mutable_parts(0)->mutable_mesh()->set_first_triangle(-1); },
                "objects[0].parts[0].mesh"},
        Refused{"NegativeCount",
                [](auto& o) { o.mutable_parts(0)->mutable_mesh()->set_triangle_count(-1); },
                "objects[0].parts[0].mesh"},
        Refused{"UnknownRole",
                [](auto& o) { o.mutable_parts(0)->set_role(static_cast<v1::PartRole>(9)); },
                "objects[0].parts[0].role"},
        Refused{"NanTransform", [](auto& o) { o.mutable_parts(0)->set_to_object(3, kNan); },
                "objects[0].parts[0].to_object"},
        Refused{"HugeTransform", [](auto& o) { o.mutable_instances(0)->set_to_plate(3, 1e7); },
                "objects[0].instances[0].to_plate"},
        Refused{"ElevenNumbers",
                [](auto& o) { o.mutable_parts(0)->mutable_to_object()->RemoveLast(); },
                "objects[0].parts[0].to_object"},
        Refused{"NanHeight", [](auto& o) { o.mutable_height_ranges(0)->set_to_mm(kNan); },
                "objects[0].height_ranges[0].from_mm, to_mm"},
        Refused{
            "UnknownPlace",
            [](auto& o) { o.mutable_instances(0)->set_place(static_cast<v1::Instance::Place>(9)); },
            "objects[0].instances[0].place"},
        Refused{"BothForms", [](auto& o) { o.set_mesh_sha256(Sha256Hex("a")); },
                "objects[0].parts"},
        Refused{"CopiesOfParts", [](auto& o) { o.set_copies(2); }, "objects[0].parts"},
        Refused{"InstancesOfAMesh",
                [](auto& o) {
                  o.clear_parts();
                  o.set_mesh_sha256(Sha256Hex("a"));
                },
                "objects[0].instances"},
        Refused{"NegativeCopies",
                [](auto& o) {
                  o.Clear();
                  o.set_mesh_sha256(Sha256Hex("a"));
                  o.set_copies(-1);
                },
                "objects[0].copies"},
        Refused{"NoMesh", [](auto& o) { o.Clear(); }, "objects[0].mesh_sha256"}),
    [](const auto& info) { return info.param.name; });

TEST(SceneWire, HasBounds) {
  Objects parts;
  v1::Object& object = *parts.Add();
  for (int64_t i = 0; i <= limits::kMaxParts; ++i)
    object.add_parts()->mutable_mesh()->set_sha256(Sha256Hex("a"));
  EXPECT_EQ(DetailOf(FromProto(parts).status()).reason, Reason::kRequestTooLarge);

  Objects ranges = ProtoOf(RichScene());
  for (int64_t i = 0; i < limits::kMaxHeightRanges; ++i) ranges[0].add_height_ranges();
  EXPECT_EQ(DetailOf(FromProto(ranges).status()).reason, Reason::kRequestTooLarge);

  Objects slices;
  v1::Object& sliced = *slices.Add();
  for (int i = 0; i < 1'000; ++i) sliced.add_parts()->mutable_mesh()->set_sha256(Sha256Hex("a"));
  for (int i = 0; i < 100; ++i) sliced.add_height_ranges();
  EXPECT_EQ(DetailOf(FromProto(slices).status()).reason, Reason::kRequestTooLarge);

  Objects copies;
  copies.Add()->set_mesh_sha256(Sha256Hex("a"));
  copies[0].set_copies(501);
  EXPECT_TRUE(FromProto(copies).ok());
  *copies.Add() = copies[0];
  EXPECT_EQ(DetailOf(FromProto(copies).status()).metadata.at("got"), "1002");

  Objects many;
  for (int64_t i = 0; i <= limits::kMaxObjects; ++i) many.Add()->set_mesh_sha256(Sha256Hex("a"));
  EXPECT_EQ(DetailOf(FromProto(many).status()).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::scene_wire_test
