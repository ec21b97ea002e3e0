#include "services/slicing/algo/mesh_io/mesh_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing {
namespace {

RawMesh Box() { return BoxMesh({0, 0, 0}, {10, 20, 30}); }

absl::StatusOr<RawMesh> Read(std::string_view bytes, MeshFormat format = MeshFormat::kUnknown) {
  return ReadMesh(bytes, format, 10'000, {});
}

TEST(ReadMesh, TellsTheFormatByContent) {
  std::string solid = ToBinaryStl(Box());
  solid.replace(0, 9, "solid foo");
  for (const std::string& bytes : {ToBinaryStl(Box()), solid, ToAsciiStl(Box()), ToObj(Box())}) {
    const auto mesh = Read(bytes);
    ASSERT_TRUE(mesh.ok()) << mesh.status();
    EXPECT_EQ(mesh->triangles.size(), 12u);
    EXPECT_EQ(mesh->positions.size(), 8u);
  }
}

struct Case {
  std::string name;
  std::string bytes;
  MeshFormat format;
  Reason want;
};

TEST(ReadMesh, SaysWhatIsWrong) {
  const std::string binary = ToBinaryStl(Box());
  const std::string no_triangles = binary.substr(0, 80) + std::string(4, '\0');
  const auto unknown = MeshFormat::kUnknown;
  const std::vector<Case> cases = {
      {"Empty", "", unknown, Reason::kMeshEmpty},
      {"Word", "hello", unknown, Reason::kMeshFormatUnknown},
      {"Gltf", "glTF" + std::string(100, 'x'), unknown, Reason::kMeshFormatUnknown},
      {"PlyWithoutEnd", "ply\nformat ascii 1.0\n", unknown, Reason::kMeshTruncated},
      {"Png", "\x89PNG" + std::string(100, 'x'), unknown, Reason::kMeshFormatUnknown},
      {"TruncatedBinary", binary.substr(0, 300), unknown, Reason::kMeshTruncated},
      {"NoTriangles", no_triangles, unknown, Reason::kMeshEmpty},
      {"AsciiNoFacet", "solid x\nendsolid x\n", unknown, Reason::kMeshEmpty},
      {"ObjNoFaces", "v 1 2 3\n", unknown, Reason::kMeshEmpty},
      {"ObjSaidToBeStl", ToObj(Box()), MeshFormat::kStl, Reason::kMeshTooLarge},
      {"StlSaidToBeObj", binary, MeshFormat::kObj, Reason::kMeshMalformed},
  };
  for (const Case& c : cases) {
    const auto mesh = Read(c.bytes, c.format);
    ASSERT_FALSE(mesh.ok()) << c.name;
    EXPECT_EQ(DetailOf(mesh.status()).reason, c.want) << c.name << mesh.status();
    EXPECT_EQ(mesh.status().code(), absl::StatusCode::kInvalidArgument) << c.name;
  }
}

TEST(ReadMeshFile, MakesAProjectOfOneMesh) {
  for (const std::string& bytes : {ToBinaryStl(Box()), ToObj(Box())}) {
    const auto all = ReadMeshFile(bytes, MeshFormat::kUnknown, 10'000, ReadDepth::kMeshes, {});
    ASSERT_TRUE(all.ok()) << all.status();
    ASSERT_EQ(all->meshes.size(), 1u);
    EXPECT_EQ(all->meshes[0].triangles.size(), 12u);
    ASSERT_EQ(all->project.objects.size(), 1u);
    const SceneObject& object = all->project.objects[0];
    ASSERT_EQ(object.parts.size(), 1u);
    EXPECT_EQ(object.parts[0].mesh, MeshRef());
    ASSERT_EQ(object.instances.size(), 1u);
    EXPECT_FALSE(object.instances[0].placed);
    EXPECT_EQ(object.instances[0].to_plate, Transform(Transform::Identity()));
    const auto structure =
        ReadMeshFile(bytes, MeshFormat::kUnknown, 10'000, ReadDepth::kStructure, {});
    ASSERT_TRUE(structure.ok()) << structure.status();
    EXPECT_TRUE(structure->meshes.empty());
    EXPECT_EQ(structure->project, all->project);
  }
}

/// Whatever is cut off or overwritten, the reader answers; run under the sanitizers this is a small
/// fuzzer.
TEST(ReadMesh, SurvivesEveryCutAndManyWrongBytes) {
  for (const std::string& good : {ToBinaryStl(Box()), ToAsciiStl(Box()), ToObj(Box())}) {
    for (size_t size = 0; size < good.size(); ++size) (void)Read(good.substr(0, size));
    for (size_t at = 0; at < good.size(); ++at) {
      for (const char byte : {'\0', '\xff', '\n', '-', '9'}) {
        std::string bad = good;
        bad[at] = byte;
        (void)Read(bad);
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::slicing
