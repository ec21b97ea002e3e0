#include "services/slicing/algo/topology/edge_table.h"

#include <gtest/gtest.h>

#include <vector>

#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::edge_table_test {
namespace {

void ExpectSoundTwins(const std::vector<Triangle>& triangles, const EdgeTable& table) {
  for (uint32_t h = 0; h < table.twins.size(); ++h) {
    const uint32_t twin = table.twins[h];
    if (twin == kNoTwin) continue;
    EXPECT_EQ(table.twins[twin], h);
    EXPECT_EQ(OriginOf(triangles, h), TargetOf(triangles, twin));
    EXPECT_EQ(TargetOf(triangles, h), OriginOf(triangles, twin));
  }
}

TEST(EdgeTable, PairsTheEdgesOfClosedMeshes) {
  for (const RawMesh& mesh : {BoxMesh({0, 0, 0}, {1, 1, 1}), TetrahedronMesh(1), TorusMesh({}),
                              Shuffled(TorusMesh({}), 3)}) {
    const EdgeTable table = BuildEdgeTable(mesh.triangles, mesh.positions.size());
    EXPECT_EQ(table.open_edges, 0);
    EXPECT_EQ(table.conflicts, 0);
    EXPECT_EQ(table.fan_count(), 0);
    EXPECT_EQ(std::count(table.twins.begin(), table.twins.end(), kNoTwin), 0);
    ExpectSoundTwins(mesh.triangles, table);
  }
}

TEST(EdgeTable, CountsOpenEdges) {
  const RawMesh box = WithoutTriangle(BoxMesh({0, 0, 0}, {1, 1, 1}), 4);
  const EdgeTable table = BuildEdgeTable(box.triangles, box.positions.size());
  EXPECT_EQ(table.open_edges, 3);
  EXPECT_EQ(std::count(table.twins.begin(), table.twins.end(), kNoTwin), 3);
}

TEST(EdgeTable, CountsConflictsAndFans) {
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(BuildEdgeTable(triangles, 4).conflicts, 1);
  triangles.push_back({1, 0, 4});
  const EdgeTable table = BuildEdgeTable(triangles, 5);
  EXPECT_EQ(table.conflicts, 0);
  EXPECT_EQ(table.fan_count(), 1);
  EXPECT_EQ(table.fans, (std::vector<uint32_t>{0, 3, 6}));
  EXPECT_EQ(table.fan_starts, (std::vector<uint32_t>{0, 3}));
  EXPECT_EQ(table.open_edges, 6);
}

/// A vertex with very many faces uses the other sort.
TEST(EdgeTable, PairsAroundACrowdedVertex) {
  std::vector<Triangle> cone;
  constexpr uint32_t kRim = 5'000;
  for (uint32_t i = 0; i < kRim; ++i)
    cone.push_back({0, 1 + (i * 7) % kRim, 1 + (i * 7 + 1) % kRim});
  const EdgeTable table = BuildEdgeTable(cone, kRim + 1);
  EXPECT_EQ(table.open_edges, kRim);
  EXPECT_EQ(table.conflicts, 0);
  ExpectSoundTwins(cone, table);
}

TEST(EdgeTable, NothingGivesNothing) { EXPECT_TRUE(BuildEdgeTable({}, 0).twins.empty()); }

}  // namespace
}  // namespace slicefarm::slicing::edge_table_test
