#include "services/slicing/algo/placement/local_placing_stage.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::local_placing_stage_test {
namespace {

/// Returns two boxes, 10 mm wide and high each, away from the origins of their files. The second
/// box has two copies.
SliceInput TwoBoxes() {
  SliceInput input;
  for (const double x : {5.0, 40.0})
    input.files.push_back({"box", MeshFormat::kStl, ToBinaryStl(Cube(x, 7, 3))});
  for (int32_t i = 0; i < 2; ++i)
    input.objects.push_back({.name = i == 0 ? "a" : "b",
                             .parts = {{.name = "", .mesh = {i, kOnlyMesh}}},
                             .ranges = {}});
  input.objects[1].copies.resize(2);
  return input;
}

SlicingOptions OfTwo() {
  SlicingOptions options;
  options.objects.resize(2);
  return options;
}

TEST(LocalPlacing, PutsMeshesOnTheBed) {
  const auto scene = MakeLocalPlacing()->Place({}, TwoBoxes(), OfTwo());
  ASSERT_TRUE(scene.ok()) << scene.status();
  ASSERT_EQ(scene->objects.size(), 2u);
  const PlacedSceneObject &a = scene->objects[0], &b = scene->objects[1];
  EXPECT_EQ(a.name, "a");
  EXPECT_EQ(a.to_origin, (Vertex{FromMm(-10), FromMm(-12), FromMm(-3)}));
  EXPECT_EQ(b.shifts.size(), 2u);
  ASSERT_EQ(a.parts.size(), 1u);
  EXPECT_EQ(a.parts[0].mesh.triangles.size(), 12u);
  EXPECT_EQ(a.parts[0].report.name, "a");
  EXPECT_TRUE(a.parts[0].report.Closed());
  for (const Vertex& v : a.parts[0].mesh.vertices) {
    EXPECT_EQ(std::abs(v.x), FromMm(5));
    EXPECT_EQ(std::abs(v.y), FromMm(5));
    EXPECT_TRUE(v.z == 0 || v.z == FromMm(10));
  }
}

TEST(LocalPlacing, HandsErrorsOn) {
  SlicingOptions small = OfTwo();
  small.bed = {{0, 0}, {FromMm(9), 0}, {FromMm(9), FromMm(9)}, {0, FromMm(9)}};
  EXPECT_EQ(DetailOf(MakeLocalPlacing()->Place({}, TwoBoxes(), small).status()).reason,
            Reason::kOutOfBuildVolume);
  SliceInput broken = TwoBoxes();
  broken.files[0].bytes.resize(99);
  EXPECT_FALSE(MakeLocalPlacing()->Place({}, std::move(broken), OfTwo()).ok());
  StageCall cancelled;
  cancelled.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(
      absl::IsCancelled(MakeLocalPlacing()->Place(cancelled, TwoBoxes(), OfTwo()).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::local_placing_stage_test
