#include "services/slicing/algo/placement/placed_object.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::placed_object_test {
namespace {

constexpr Coord kMm = kNmPerMm;
const CancelToken kNeverCancelled;

/// Returns an object with a solid part and a modifier that extends beyond it, both of one file.
ObjectInput WithModifier() {
  ObjectInput object;
  object.parts.resize(2);
  object.parts[1].role = PartRole::kModifier;
  object.parts[1].to_object(0, 3) = 50;
  return object;
}

std::vector<MeshFile> Box() {
  return {{"box.stl", MeshFormat::kStl, ToBinaryStl(BoxMesh({5, 5, 5}, {15, 25, 45}))}};
}

TEST(PlaceParts, SolidPartsAloneSayWhereTheOriginIs) {
  const std::vector<ObjectInput> objects = {WithModifier()};
  const auto source = MakeDirectMeshSource();
  PartMeshes meshes(Box(), objects, *source, kNeverCancelled);
  const auto placed = PlaceParts(objects[0], meshes);
  ASSERT_TRUE(placed.ok()) << placed.status();
  EXPECT_EQ(placed->top_nm, 40 * kMm);
  EXPECT_EQ(placed->to_origin.x, -10 * kMm);
  EXPECT_EQ(placed->to_origin.z, -5 * kMm);
  ASSERT_EQ(placed->footprint.size(), 4u);
  for (const Point corner : placed->footprint) EXPECT_LE(std::abs(corner.x), 5 * kMm);
  EXPECT_EQ(placed->parts.size(), 2u);
}

TEST(PartMeshes, AreThereAsOftenAsTheyAreUsed) {
  const std::vector<ObjectInput> objects = {WithModifier(), WithModifier()};
  const auto source = MakeDirectMeshSource();
  PartMeshes meshes(Box(), objects, *source, kNeverCancelled);
  for (const ObjectInput& object : objects) EXPECT_TRUE(PlaceParts(object, meshes).ok());
}

TEST(PartMeshes, RefuseWhatIsNotThere) {
  const std::vector<ObjectInput> objects = {WithModifier()};
  const auto source = MakeDirectMeshSource();
  PartMeshes meshes(Box(), objects, *source, kNeverCancelled);
  for (const MeshRef& ref : {MeshRef{1, 0, 0, -1}, MeshRef{-1, 0, 0, -1}, MeshRef{0, 1, 0, -1}})
    EXPECT_EQ(DetailOf(meshes.Take(ref).status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::slicing::placed_object_test
