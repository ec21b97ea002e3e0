#include "services/slicing/algo/mesh_reader/mesh_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::mesh_reader_test {
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

TEST(ReadMesh, NamesTheFormatOfACadModel) {
  const absl::Status status = Read("ISO-10303-21;\nHEADER;\n", MeshFormat::kUnknown).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshFormatUnknown);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("STEP"));
}

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
      {"GitLfs", "version https://git-lfs.github.com/spec/v1\noid sha256:" + std::string(64, '9'),
       unknown, Reason::kMeshFormatUnknown},
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

/// Returns true if later steps can use the mesh: its corners exist, at positions within the limit.
bool IsSound(const RawMesh& mesh) {
  const auto exists = [&](uint32_t corner) { return corner < mesh.positions.size(); };
  const auto is_near = [](double x) { return std::abs(x) <= 10'000; };  // false for NaN
  return !mesh.triangles.empty() &&
         std::all_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const auto& t) { return std::all_of(t.begin(), t.end(), exists); }) &&
         std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const Vector3& p) {
           return is_near(p.x()) && is_near(p.y()) && is_near(p.z());
         });
}

/// Expects a valid mesh or one of these errors.
void ExpectAnswer(const absl::StatusOr<RawMesh>& mesh, const std::vector<Reason>& reasons) {
  if (mesh.ok()) {
    EXPECT_TRUE(IsSound(*mesh));
    return;
  }
  EXPECT_EQ(mesh.status().code(), absl::StatusCode::kInvalidArgument) << mesh.status();
  EXPECT_THAT(reasons, testing::Contains(DetailOf(mesh.status()).reason)) << mesh.status();
}

TEST(ReadMesh, TellsEveryCutOfAnStl) {
  const std::string binary = ToBinaryStl(Box()), ascii = ToAsciiStl(Box());
  for (const std::string& good : {binary, ascii}) {
    for (size_t size = 1; size < good.size(); ++size) {
      const std::string cut = good.substr(0, size);
      const auto mesh = Read(cut, MeshFormat::kStl);
      const bool has_end = cut.find("endsolid") != std::string::npos;
      EXPECT_EQ(mesh.ok(), has_end) << size;
      // An ASCII file may be cut within a statement.
      ExpectAnswer(mesh, good == binary
                             ? std::vector{Reason::kMeshTruncated}
                             : std::vector{Reason::kMeshTruncated, Reason::kMeshMalformed});
      // `s` alone could be the smoothing group of an OBJ.
      ExpectAnswer(Read(cut), {Reason::kMeshTruncated, Reason::kMeshMalformed,
                               Reason::kMeshFormatUnknown, Reason::kMeshEmpty});
    }
  }
}

// An OBJ does not state its length, so a cut file is valid if its last face is complete.
TEST(ReadMesh, TakesOfACutObjTheFacesThatAreThere) {
  const std::string good = ToObj(Box());
  const size_t faces_at = good.find("f ");
  for (size_t size = 1; size < good.size(); ++size) {
    const auto mesh = Read(good.substr(0, size), MeshFormat::kObj);
    ExpectAnswer(mesh, {Reason::kMeshEmpty, Reason::kMeshMalformed});
    if (size <= faces_at) {
      EXPECT_FALSE(mesh.ok()) << size;
    }
    if (good[size - 1] == '\n' && size > faces_at) {
      ASSERT_TRUE(mesh.ok()) << mesh.status();
      EXPECT_EQ(std::ssize(mesh->triangles),
                std::count(good.begin() + faces_at, good.begin() + size, 'f'));
    }
  }
}

TEST(ReadMesh, AnswersToWrongBytes) {
  const std::vector<Reason> reasons = {Reason::kMeshFormatUnknown, Reason::kMeshTruncated,
                                       Reason::kMeshMalformed,     Reason::kMeshNotFinite,
                                       Reason::kOutOfRange,        Reason::kMeshTooLarge,
                                       Reason::kMeshEmpty};
  int refused = 0;
  for (const std::string& good : {ToBinaryStl(Box()), ToAsciiStl(Box()), ToObj(Box())}) {
    for (size_t at = 0; at < good.size(); ++at) {
      for (const char byte : {'\0', '\xff', '\n', '-', '9'}) {
        std::string bad = good;
        bad[at] = byte;
        const auto mesh = Read(bad);
        ExpectAnswer(mesh, reasons);
        refused += !mesh.ok();
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace slicefarm::slicing::mesh_reader_test
