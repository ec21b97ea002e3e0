#include "services/slicing/algo/mesh_io/stl_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::stl_reader_test {
namespace {

constexpr double kLimit = 10'000;

RawMesh Box() { return BoxMesh({0, 0, 0}, {10, 20, 30}); }

std::string WithCount(std::string stl, uint32_t count) {
  std::memcpy(stl.data() + 80, &count, sizeof count);
  return stl;
}

std::string WithNumber(std::string stl, size_t triangle, size_t coordinate, float value) {
  std::memcpy(stl.data() + 84 + 50 * triangle + 12 + 4 * coordinate, &value, sizeof value);
  return stl;
}

TEST(BinaryStl, WeldsCornersByPosition) {
  const auto mesh = ReadBinaryStl(ToBinaryStl(Box()), kLimit, {});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->triangles.size(), 12u);
  EXPECT_EQ(mesh->positions.size(), 8u);
  EXPECT_EQ(mesh->positions[mesh->triangles[1][1]], (Vector3{0, 20, 0}));
}

TEST(BinaryStl, NegativeZeroIsZero) {
  const std::string stl = WithNumber(ToBinaryStl(Box()), 0, 0, -0.0f);
  const auto mesh = ReadBinaryStl(stl, kLimit, {});
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->positions.size(), 8u);
}

struct HostileCase {
  std::string name;
  std::string bytes;
  Reason want;
  std::map<std::string, std::string> metadata;
};

TEST(BinaryStl, RefusesWithReasonAndPlace) {
  const std::string good = ToBinaryStl(Box());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<HostileCase> cases = {
      {"Empty", "", Reason::kMeshTruncated, {{"got", "0"}}},
      {"HeaderOnly", good.substr(0, 83), Reason::kMeshTruncated, {{"limit", "84"}}},
      {"Truncated",
       good.substr(0, good.size() - 1),
       Reason::kMeshTruncated,
       {{"limit", "684"}, {"got", "683"}}},
      {"TooLong", good + "x", Reason::kMeshMalformed, {{"limit", "684"}, {"got", "685"}}},
      {"CountTooSmall", WithCount(good, 11), Reason::kMeshMalformed, {}},
      {"BillionClaimed",
       WithCount(good, 1'000'000'000),
       Reason::kMeshTooLarge,
       {{"limit", "20000000"}, {"got", "1000000000"}}},
      {"AllOnesClaimed", WithCount(good, UINT32_MAX), Reason::kMeshTooLarge, {}},
      {"NaN", WithNumber(good, 3, 4, nan), Reason::kMeshNotFinite, {{"triangle", "3"}}},
      {"Infinity",
       WithNumber(good, 11, 8, -infinity),
       Reason::kMeshNotFinite,
       {{"triangle", "11"}}},
      {"FarOut", WithNumber(good, 0, 0, 10'001), Reason::kOutOfRange, {{"triangle", "0"}}},
  };
  for (const HostileCase& c : cases) {
    const auto mesh = ReadBinaryStl(c.bytes, kLimit, {});
    ASSERT_FALSE(mesh.ok()) << c.name;
    const ErrorDetail detail = DetailOf(mesh.status());
    EXPECT_EQ(detail.reason, c.want) << c.name;
    for (const auto& [key, value] : c.metadata)
      EXPECT_EQ(detail.metadata.count(key) ? detail.metadata.at(key) : "", value) << c.name << key;
  }
}

TEST(BinaryStl, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  const auto mesh = ReadBinaryStl(ToBinaryStl(Box()), kLimit, cancelled);
  EXPECT_EQ(mesh.status().code(), absl::StatusCode::kCancelled);
}

TEST(AsciiStl, ReadsTheSameAsBinary) {
  const auto binary = ReadBinaryStl(ToBinaryStl(Box()), kLimit, {});
  const auto ascii = ReadAsciiStl(ToAsciiStl(Box()), kLimit, {});
  ASSERT_TRUE(ascii.ok()) << ascii.status();
  EXPECT_EQ(ascii->triangles, binary->triangles);
  EXPECT_EQ(ascii->positions, binary->positions);
}

std::string Facet(const std::string& inside) {
  return "solid x\nfacet normal 0 0 1\nouter loop\n" + inside + "endloop\nendfacet\nendsolid x\n";
}

const char kCorners[] = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";

TEST(AsciiStl, AcceptsWhatExportersWrite) {
  std::string crlf = Facet(kCorners), upper = Facet(kCorners);
  for (size_t at = 0; (at = crlf.find('\n', at)) != std::string::npos; at += 2)
    crlf.replace(at, 1, "\r\n");
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  std::string mac = Facet(kCorners);
  for (char& c : mac) c = c == '\n' ? '\r' : c;
  std::string mixed = Facet(kCorners);  // CR, LF, CR LF alternately
  for (size_t at = 0, line = 0; (at = mixed.find('\n', at)) != std::string::npos; ++line) {
    const std::string end = line % 3 == 0 ? "\r" : line % 3 == 1 ? "\n" : "\r\n";
    mixed.replace(at, 1, end);
    at += end.size();
  }
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"CrLf", crlf},
      {"UpperCase", upper},
      {"CarriageReturns", mac},
      {"MixedLineEnds", mixed},
      {"Utf8Mark", "\xEF\xBB\xBF" + Facet(kCorners)},
      {"Exponents", Facet("vertex 0e0 0 -0.0E+00\nvertex 1.0e+000 0 0\nvertex 0 1000E-3 0\n")},
      {"BlankLines", "\n\n" + Facet("\n" + std::string(kCorners) + "\n   \n")},
      {"NoNormal",
       "solid\nfacet\nouter loop\n" + std::string(kCorners) + "endloop\nendfacet\nendsolid"},
      {"TwoSolids", Facet(kCorners) + "solid empty\nendsolid\n"},
  };
  for (const auto& [name, text] : cases) {
    const auto mesh = ReadAsciiStl(text, kLimit, {});
    ASSERT_TRUE(mesh.ok()) << name << mesh.status();
    EXPECT_EQ(mesh->triangles.size(), 1u) << name;
    EXPECT_EQ(mesh->positions, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << name;
  }
}

TEST(AsciiStl, RefusesWithReasonAndLine) {
  const std::string good = Facet(kCorners);
  const auto metadata = [](const char* line) {
    return std::map<std::string, std::string>{{"line", line}};
  };
  const std::vector<HostileCase> cases = {
      {"NoEnd", good.substr(0, good.find("endsolid")), Reason::kMeshTruncated, metadata("8")},
      {"CutInFacet", good.substr(0, good.find("vertex 1")), Reason::kMeshTruncated, metadata("4")},
      {"Garbage", "solid x\nhello\n", Reason::kMeshMalformed, metadata("2")},
      {"Nul", std::string("solid x\n\0\0\n", 11), Reason::kMeshMalformed, metadata("2")},
      {"TwoVertices", Facet("vertex 0 0 0\nvertex 1 0 0\n"), Reason::kMeshMalformed, metadata("7")},
      {"FourVertices", Facet(kCorners + std::string("vertex 1 1 0\n")), Reason::kMeshMalformed,
       metadata("7")},
      {"TwoNumbers", Facet("vertex 0 0\n"), Reason::kMeshMalformed, metadata("4")},
      {"DecimalComma", Facet("vertex 0,5 0 0\n"), Reason::kMeshMalformed, metadata("4")},
      {"Nested", "solid x\nfacet\nfacet\n", Reason::kMeshMalformed, metadata("3")},
      {"VertexOutside", "solid x\nvertex 0 0 0\n", Reason::kMeshMalformed, metadata("2")},
      {"SolidInFacet", "solid x\nfacet\nendsolid\n", Reason::kMeshMalformed, metadata("3")},
      {"NaN", Facet("vertex 0 nan 0\n"), Reason::kMeshNotFinite, metadata("4")},
      {"Overflow", Facet("vertex 0 1e999 0\n"), Reason::kMeshNotFinite, metadata("4")},
      {"FarOut", Facet("vertex 0 0 -10000.5\n"), Reason::kOutOfRange, metadata("4")},
      {"LongLine",
       "solid " + std::string(2000, 'x') + "\n",
       Reason::kMeshMalformed,
       {{"limit", "1024"}, {"got", "2006"}, {"line", "1"}}},
  };
  for (const HostileCase& c : cases) {
    const auto mesh = ReadAsciiStl(c.bytes, kLimit, {});
    ASSERT_FALSE(mesh.ok()) << c.name;
    const ErrorDetail detail = DetailOf(mesh.status());
    EXPECT_EQ(detail.reason, c.want) << c.name << mesh.status();
    for (const auto& [key, value] : c.metadata)
      EXPECT_EQ(detail.metadata.count(key) ? detail.metadata.at(key) : "", value) << c.name;
  }
}

TEST(StlDetection, TellsTheFlavours) {
  const std::string binary = ToBinaryStl(Box());
  std::string solid_header = binary;
  solid_header.replace(0, 10, "solid part");
  EXPECT_TRUE(IsBinaryStl(binary));
  EXPECT_TRUE(IsBinaryStl(solid_header));
  EXPECT_FALSE(IsBinaryStl(binary.substr(0, 200)));
  EXPECT_FALSE(LooksLikeAsciiStl(solid_header));
  EXPECT_TRUE(LooksLikeAsciiStl(ToAsciiStl(Box())));
  EXPECT_TRUE(LooksLikeAsciiStl("\n  SOLID\n"));
  EXPECT_TRUE(LooksLikeAsciiStl("\xEF\xBB\xBFsolid x\n"));
  EXPECT_FALSE(LooksLikeAsciiStl("solidly\n"));
}

}  // namespace
}  // namespace slicefarm::slicing::stl_reader_test
