#include "services/slicing/algo/mesh_io/ply_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::ply_reader_test {
namespace {

std::string Header(std::string_view format, size_t vertices, size_t faces) {
  return fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty double y\n"
      "property uchar red\nproperty float z\nproperty list uchar float weights\n"
      "element face {}\nproperty list ushort int vertex_indices\nproperty short flags\n"
      "end_header\n",
      format, vertices, faces);
}

template <typename T>
void Append(std::string& out, T value, bool swap) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (swap) std::reverse(bytes, bytes + sizeof value);
  out.append(bytes, sizeof value);
}

std::string ToBinaryPly(const RawMesh& mesh, bool big) {
  std::string out = Header(big ? "binary_big_endian" : "binary_little_endian",
                           mesh.positions.size(), mesh.triangles.size());
  for (const Vector3& p : mesh.positions) {
    Append(out, static_cast<float>(p.x()), big);
    Append(out, p.y(), big);
    Append(out, uint8_t{200}, big);
    Append(out, static_cast<float>(p.z()), big);
    Append(out, uint8_t{2}, big);
    Append(out, 0.5F, big);
    Append(out, 0.5F, big);
  }
  for (const auto& t : mesh.triangles) {
    Append(out, uint16_t{3}, big);
    for (const uint32_t corner : t) Append(out, static_cast<int32_t>(corner), big);
    Append(out, int16_t{-1}, big);
  }
  return out;
}

std::string ToAsciiPly(const RawMesh& mesh) {
  std::string out = Header("ascii", mesh.positions.size(), mesh.triangles.size());
  for (const Vector3& p : mesh.positions)
    out += fmt::format("{} {} 200 {} 2 0.5 0.5\n", p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles) out += fmt::format("3 {} {} {} -1\n", t[0], t[1], t[2]);
  return out;
}

absl::StatusOr<RawMesh> Read(std::string_view bytes) {
  return ReadMesh(bytes, MeshFormat::kUnknown, 10'000, {});
}

TEST(ReadPly, ReadsAllEncodings) {
  const RawMesh torus = TorusMesh({.around = 8, .sides = 5});
  const auto want = Read(ToBinaryStl(torus));
  for (const std::string& bytes :
       {ToAsciiPly(torus), ToBinaryPly(torus, false), ToBinaryPly(torus, true)}) {
    const auto mesh = Read(bytes);
    ASSERT_TRUE(mesh.ok()) << mesh.status();
    EXPECT_EQ(mesh->triangles, want->triangles);
    ASSERT_EQ(mesh->positions.size(), want->positions.size());
    for (size_t i = 0; i < mesh->positions.size(); ++i)
      EXPECT_NEAR(mesh->positions[i].x(), want->positions[i].x(), 1e-5);
  }
}

std::string Small(std::string_view vertices, std::string_view faces, int count = 1) {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_index\nend_header\n{}\n{}",
      count, vertices, faces);
}

constexpr std::string_view kCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0";

TEST(ReadPly, MakesFansOfPolygons) {
  const auto mesh = Read(Small(kCorners, "4 0 1 2 3"));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->triangles, (std::vector<std::array<uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadPly, FacesMayStandBeforeTheVertices) {
  const auto mesh = Read(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
      "3 0 1 2 0 0 0 1 0 0 0 1 0\n");
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->triangles.size(), 1u);
}

TEST(ReadPly, SaysWhatIsWrong) {
  struct Case {
    std::string name, bytes;
    Reason want;
  };
  const std::string lying =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 4294967295\n"
      "property list uint int vertex_index\nend_header\n" +
      std::string(36, '\0');
  const std::vector<Case> cases = {
      {"FewerVertices", Small("0 0 0", ""), Reason::kMeshTruncated},
      {"FewerFaces", Small(kCorners, "3 0 1 2", 2), Reason::kMeshTruncated},
      {"NoNumber", Small("0 0 zero\n1 0 0\n1 1 0\n0 1 0", "3 0 1 2"), Reason::kMeshMalformed},
      {"Nan", Small("0 0 nan\n1 0 0\n1 1 0\n0 1 0", "3 0 1 2"), Reason::kMeshNotFinite},
      {"Far", Small("0 0 1e9\n1 0 0\n1 1 0\n0 1 0", "3 0 1 2"), Reason::kOutOfRange},
      {"IndexBeyond", Small(kCorners, "3 0 1 4"), Reason::kMeshMalformed},
      {"IndexNegative", Small(kCorners, "3 0 1 -1"), Reason::kMeshMalformed},
      {"IndexBroken", Small(kCorners, "3 0 1 1.5"), Reason::kMeshMalformed},
      {"TwoCorners", Small(kCorners, "2 0 1"), Reason::kMeshMalformed},
      {"ManyCorners", Small(kCorners, "5000 0 1 2"), Reason::kMeshMalformed},
      {"LengthOfNothing", Small(kCorners, "-3 0 1 2"), Reason::kMeshMalformed},
      {"LyingCounts", lying + std::string("\xff\xff\xff\xff", 4), Reason::kMeshMalformed},
      {"LyingFaces", lying, Reason::kMeshTruncated},
      {"NoFaces", Small(kCorners, "", 0), Reason::kMeshEmpty},
      {"NoAxis", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
       Reason::kMeshMalformed},
  };
  for (const Case& c : cases) {
    const auto mesh = Read(c.bytes);
    ASSERT_FALSE(mesh.ok()) << c.name;
    EXPECT_EQ(DetailOf(mesh.status()).reason, c.want) << c.name << mesh.status();
  }
}

TEST(ReadPly, SurvivesEveryCutAndManyWrongBytes) {
  const RawMesh box = Cube(0, 0, 0);
  for (const std::string& good :
       {ToAsciiPly(box), ToBinaryPly(box, false), ToBinaryPly(box, true)}) {
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

TEST(ReadPly, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(ReadPly(ToAsciiPly(Cube(0, 0, 0)), 100, cancelled).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::ply_reader_test
