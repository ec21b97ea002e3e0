#include "tests/load/generator/algo/part_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace slicefarm::load::part_maker_test {
namespace {

using Vertex = std::array<float, 3>;
using Triangle = std::array<Vertex, 3>;

std::vector<Triangle> Read(const std::string& stl) {
  uint32_t number = 0;
  std::memcpy(&number, stl.data() + 80, sizeof number);
  EXPECT_EQ(stl.size(), 84 + 50 * static_cast<size_t>(number));
  std::vector<Triangle> triangles(number);
  for (uint32_t i = 0; i < number; ++i) {
    std::memcpy(&triangles[i], stl.data() + 84 + 50 * i + 12, sizeof(Triangle));
  }
  return triangles;
}

double SignedVolume(const std::vector<Triangle>& triangles) {
  double six = 0;
  for (const auto& [a, b, c] : triangles) {
    six += a[0] * (double{b[1]} * c[2] - double{b[2]} * c[1]) -
           a[1] * (double{b[0]} * c[2] - double{b[2]} * c[0]) +
           a[2] * (double{b[0]} * c[1] - double{b[1]} * c[0]);
  }
  return six / 6;
}

class PartMakerTest : public testing::TestWithParam<PartSize> {};

// Each edge occurs once in each direction: the part is closed, and all faces have the same
// orientation.
TEST_P(PartMakerTest, PartsAreClosedAndFaceOutwards) {
  const auto triangles = Read(MakePart(GetParam(), 1));
  std::vector<std::pair<Vertex, Vertex>> edges, turned;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      edges.emplace_back(t[i], t[(i + 1) % 3]);
      turned.emplace_back(t[(i + 1) % 3], t[i]);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(turned.begin(), turned.end());
  EXPECT_EQ(std::adjacent_find(edges.begin(), edges.end()), edges.end());
  EXPECT_TRUE(edges == turned);  // avoids a long failure message
  EXPECT_GT(SignedVolume(triangles), 50);
}

TEST_P(PartMakerTest, HasItsNumberOfTriangles) {
  EXPECT_EQ(static_cast<int>(Read(MakePart(GetParam(), 1)).size()), TrianglesOf(GetParam()));
}

TEST_P(PartMakerTest, TheSeedDecides) {
  EXPECT_EQ(MakePart(GetParam(), 1), MakePart(GetParam(), 1));
  EXPECT_NE(MakePart(GetParam(), 1), MakePart(GetParam(), 2));
}

INSTANTIATE_TEST_SUITE_P(Sizes, PartMakerTest,
                         testing::Values(PartSize::kTiny, PartSize::kMedium, PartSize::kHuge));

TEST(PartMaker, SizesAreWhatTheySay) {
  EXPECT_EQ(TrianglesOf(PartSize::kTiny), 12);
  EXPECT_EQ(TrianglesOf(PartSize::kMedium), 5'000);
  EXPECT_EQ(TrianglesOf(PartSize::kHuge), 500'000);
}

TEST(PickSize, MixedIsMostlyTiny) {
  std::map<PartSize, int> sizes;
  for (uint64_t i = 0; i < 100'000; ++i) ++sizes[PickSize(Mix::kMixed, 9, i)];
  EXPECT_NEAR(sizes[PartSize::kTiny], 80'000, 700);
  EXPECT_NEAR(sizes[PartSize::kMedium], 18'000, 700);
  EXPECT_NEAR(sizes[PartSize::kHuge], 2'000, 250);
}

TEST(PickSize, OthersAreOfOneSize) {
  EXPECT_EQ(PickSize(Mix::kTiny, 1, 2), PartSize::kTiny);
  EXPECT_EQ(PickSize(Mix::kMedium, 1, 2), PartSize::kMedium);
  EXPECT_EQ(PickSize(Mix::kHuge, 1, 2), PartSize::kHuge);
}

TEST(Mix, NamesGoBothWays) {
  for (const Mix mix : {Mix::kTiny, Mix::kMedium, Mix::kHuge, Mix::kMixed}) {
    EXPECT_EQ(MixFromName(MixName(mix)), mix);
  }
  EXPECT_EQ(MixFromName("large"), std::nullopt);
}

}  // namespace
}  // namespace slicefarm::load::part_maker_test
