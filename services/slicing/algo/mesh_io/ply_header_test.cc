#include "services/slicing/algo/mesh_io/ply_header.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::ply_header_test {
namespace {

constexpr std::string_view kHead = "ply\nformat ascii 1.0\n";

TEST(ReadPlyHeader, TellsElementsAndProperties) {
  const std::string text =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment by hand\nobj_info x\n"
      "element vertex 8\nproperty float32 x\nproperty double y\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\ndata";
  const auto header = ReadPlyHeader(text);
  ASSERT_TRUE(header.ok()) << header.status();
  EXPECT_EQ(header->encoding, PlyEncoding::kBigEndian);
  EXPECT_EQ(text.substr(header->bytes), "data");
  ASSERT_EQ(header->elements.size(), 2u);
  EXPECT_EQ(header->elements[0].name, "vertex");
  EXPECT_EQ(header->elements[0].count, 8);
  ASSERT_EQ(header->elements[0].properties.size(), 2u);
  EXPECT_EQ(header->elements[0].properties[0].type, PlyType::kFloat);
  EXPECT_EQ(header->elements[0].properties[1].type, PlyType::kDouble);
  EXPECT_TRUE(header->elements[1].properties[0].is_list);
  EXPECT_EQ(header->elements[1].properties[0].count_type, PlyType::kUint8);
}

TEST(ReadPlyHeader, SaysWhatIsWrong) {
  struct Case {
    std::string rest;
    Reason want;
    std::string line;
  };
  const std::vector<Case> cases = {
      {"", Reason::kMeshTruncated, "2"},
      {"end_head\n", Reason::kMeshMalformed, "3"},
      {"element vertex -1\n", Reason::kMeshMalformed, "3"},
      {"element vertex 99999999999999999999\n", Reason::kMeshMalformed, "3"},
      {"property float x\n", Reason::kMeshMalformed, "3"},
      {"element v 1\nproperty real x\n", Reason::kMeshMalformed, "4"},
      {"element v 1\nproperty list float int x\n", Reason::kMeshMalformed, "4"},
      {std::string("element \0v 1\n", 13), Reason::kMeshMalformed, "3"},
      {"format utf 1.0\n", Reason::kMeshMalformed, "3"},
      {"comment " + std::string(2000, 'x') + "\n", Reason::kMeshMalformed, "3"},
  };
  for (const Case& c : cases) {
    const auto header = ReadPlyHeader(std::string(kHead) + c.rest);
    ASSERT_FALSE(header.ok()) << c.rest;
    EXPECT_EQ(DetailOf(header.status()).reason, c.want) << header.status();
    EXPECT_EQ(DetailOf(header.status()).metadata["line"], c.line) << header.status();
  }
  EXPECT_FALSE(ReadPlyHeader("ply\nend_header\n").ok());
}

TEST(PlySize, IsThatOfTheType) {
  EXPECT_EQ(PlySize(PlyType::kInt8), 1u);
  EXPECT_EQ(PlySize(PlyType::kUint16), 2u);
  EXPECT_EQ(PlySize(PlyType::kFloat), 4u);
  EXPECT_EQ(PlySize(PlyType::kDouble), 8u);
}

}  // namespace
}  // namespace slicefarm::slicing::ply_header_test
