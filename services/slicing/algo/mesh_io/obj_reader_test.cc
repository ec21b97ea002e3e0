#include "services/slicing/algo/mesh_io/obj_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::obj_reader_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr double kLimit = 10'000;
using Face = std::array<uint32_t, 3>;

const char kSquare[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, ReadsTheSameAsItWasWritten) {
  const RawMesh box = BoxMesh({0, 0, 0}, {10, 20, 30});
  const auto mesh = ReadObj(ToObj(box), kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->positions, SizeIs(8));
  for (size_t i = 0; i < box.triangles.size(); ++i)
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_EQ(mesh->positions[mesh->triangles[i][corner]],
                box.positions[box.triangles[i][corner]]);
}

struct FaceCase {
  std::string name;
  std::string faces;
};

TEST(Obj, KnowsAllWaysToNameCorners) {
  const std::vector<FaceCase> cases = {
      {"Plain", "f 1 2 3 4\n"},
      {"Negative", "f -4 -3 -2 -1\n"},
      {"Textures", "vt 0 0\nf 1/1 2/1 3/1 4/1\n"},
      {"Normals", "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n"},
      {"All", "f 1/1/1 2/2/2 3/3/3 4/4/4\n"},
      {"Comment", "f 1 2 3 4 # the square\n"},
      {"CrLf", "f 1 2 3 4\r\n"},
      {"Continued", "f 1 2 \\\n 3 4\n"},
      {"Indented", "\t f  1   2 3\t4  \n"},
      {"Others", "mtllib /etc/passwd\nusemtl x\ng a b\ns off\nf 1 2 3 4\nl 1 2\n"},
  };
  for (const FaceCase& c : cases) {
    const auto mesh = ReadObj(kSquare + c.faces, kLimit, {});
    ASSERT_TRUE(mesh.ok()) << c.name << mesh.status();
    EXPECT_THAT(mesh->triangles, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3})) << c.name;
  }
}

TEST(Obj, AnIndexMayBeAheadOfItsVertex) {
  const auto mesh = ReadObj(std::string("f 1 2 3\n") + kSquare, kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->triangles, SizeIs(1));
}

TEST(Obj, WeldsEqualVerticesAndLeavesOutUnusedOnes) {
  const auto mesh =
      ReadObj("v 0 0 0\nv 9 9 9\nv 1 0 0\nv -0 0 0\nv 0 1 0\nf 1 3 5\nf 4 5 3\n", kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->positions, SizeIs(3));
  EXPECT_THAT(mesh->triangles, ElementsAre(Face{0, 1, 2}, Face{0, 2, 1}));
}

struct HostileCase {
  std::string name;
  std::string text;
  Reason want;
  std::map<std::string, std::string> metadata;
};

TEST(Obj, RefusesWithReasonAndLine) {
  std::string large_face = "f";
  for (int i = 0; i < 1025; ++i) large_face += " 1";
  const std::vector<HostileCase> cases = {
      {"IndexZero", "f 0 1 2\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"IndexTooHigh",
       "f 1 2 5\n",
       Reason::kMeshMalformed,
       {{"line", "5"}, {"limit", "4"}, {"got", "5"}}},
      {"IndexTooLow", "f -5 1 2\n", Reason::kMeshMalformed, {{"line", "5"}, {"got", "-5"}}},
      {"IndexHuge", "f 1 2 99999999999999999999\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"IndexBillions", "f 1 2 4294967297\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"IndexNotANumber", "f a b c\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"IndexFraction", "f 1.5 2 3\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"TwoCorners", "f 1 2\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"LargeFace", large_face + "\n", Reason::kMeshMalformed, {{"limit", "1024"}, {"line", "5"}}},
      {"TwoNumbers", "v 1 2\n", Reason::kMeshMalformed, {{"line", "5"}}},
      {"NaN", "v 1 nan 2\n", Reason::kMeshNotFinite, {{"line", "5"}}},
      {"FarOut", "v 1 2 1e5\n", Reason::kOutOfRange, {{"line", "5"}}},
      {"Garbage", "\x01\x02\x03\n", Reason::kMeshMalformed, {{"line", "5"}}},
  };
  for (const HostileCase& c : cases) {
    const auto mesh = ReadObj(kSquare + c.text, kLimit, {});
    ASSERT_FALSE(mesh.ok()) << c.name;
    const ErrorDetail detail = DetailOf(mesh.status());
    EXPECT_EQ(detail.reason, c.want) << c.name << mesh.status();
    for (const auto& [key, value] : c.metadata)
      EXPECT_EQ(detail.metadata.count(key) ? detail.metadata.at(key) : "", value) << c.name;
  }
}

TEST(Obj, LongestAllowedFaceFitsALine) {
  std::string text = kSquare;
  text += "f";
  for (int i = 0; i < 1024; ++i) text += " -1/-100000000/-100000000";
  const auto mesh = ReadObj(text, kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->triangles, SizeIs(1022));
}

TEST(Obj, VerticesCanStayAsTheFileNumbersThem) {
  const std::string text = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 0 0\nv 0 1 0\nf 4 3 5\nf 2 3 5\n";
  const auto mesh = ReadObjAsNumbered(text, kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->positions, SizeIs(5));
  EXPECT_THAT(mesh->triangles, ElementsAre(Face{3, 2, 4}, Face{1, 2, 4}));
  EXPECT_THAT(ReadObj(text, kLimit, {})->positions, SizeIs(3));
}

TEST(Obj, CanBeCancelled) {
  const auto mesh = ReadObj(kSquare, kLimit, CancelToken([] { return true; }));
  EXPECT_EQ(mesh.status().code(), absl::StatusCode::kCancelled);
}

TEST(ObjDetection, LooksAtTheFirstStatement) {
  EXPECT_TRUE(LooksLikeObj("# Blender\n\nmtllib a.mtl\n"));
  EXPECT_TRUE(LooksLikeObj("v 1 2 3\n"));
  EXPECT_FALSE(LooksLikeObj("solid x\n"));
  EXPECT_FALSE(LooksLikeObj("# only a comment\n"));
  EXPECT_FALSE(LooksLikeObj(""));
}

}  // namespace
}  // namespace slicefarm::slicing::obj_reader_test
