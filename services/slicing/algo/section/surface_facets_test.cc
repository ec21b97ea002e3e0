#include "services/slicing/algo/section/surface_facets.h"

#include <gtest/gtest.h>

namespace slicefarm::slicing::surface_facets_test {
namespace {

constexpr Coord kMm = 1'000'000;

std::vector<LayerPlane> Layers(int count) {
  std::vector<LayerPlane> planes;
  for (int i = 0; i < count; ++i) planes.push_back({{i, (i + 1) * kMm, kMm}, i * kMm + kMm / 2});
  return planes;
}

/// Returns a mesh of one face.
IndexedMesh Face(Vertex a, Vertex b, Vertex c) { return {{a, b, c}, {{0, 1, 2}}}; }

std::vector<size_t> Counts(const IndexedMesh& mesh) {
  const IndexedMesh* const meshes[] = {&mesh};
  std::vector<size_t> counts;
  const std::vector<int64_t> counted = CountFacets(meshes, Layers(4));
  for (const auto& layer : FacetsOfLayers(meshes, Layers(4), counted)) {
    EXPECT_EQ(counted[counts.size()], std::ssize(layer));
    counts.push_back(layer.size());
  }
  return counts;
}

TEST(FacetsOfLayers, AreInTheLayersThatTheyReach) {
  using Result = std::vector<size_t>;
  const Vertex a{0, 0, 1'500'000}, b{10 * kMm, 0, 1'700'000}, c{0, 10 * kMm, 2'300'000};
  EXPECT_EQ(Counts(Face(a, b, c)), (Result{0, 1, 1, 0}));
  EXPECT_EQ(Counts(Face(a, c, b)), (Result{0, 0, 0, 0})) << "the lower side";
  const Vertex level_b{10 * kMm, 0, 2 * kMm}, level_c{0, 10 * kMm, 2 * kMm};
  EXPECT_EQ(Counts(Face({0, 0, 2 * kMm}, level_b, level_c)), (Result{0, 1, 1, 0}));
  EXPECT_EQ(Counts(Face({0, 0, 0}, {10 * kMm, 0, 0}, {10 * kMm, 0, 4 * kMm})), (Result{0, 0, 0, 0}))
      << "vertical";
}

TEST(FacetsOfLayers, HaveHeightsAboveTheTop) {
  const IndexedMesh mesh = Face({0, 0, 1'500'000}, {10 * kMm, 0, 1'700'000}, {0, kMm, 2'300'000});
  const IndexedMesh* const meshes[] = {&mesh};
  const auto layers = FacetsOfLayers(meshes, Layers(4), CountFacets(meshes, Layers(4)));
  const std::array<Point, 3> corners = {Point{0, 0}, Point{10 * kMm, 0}, Point{0, kMm}};
  EXPECT_EQ(layers[1][0].corners, corners);
  EXPECT_EQ(layers[1][0].up_nm, (std::array<Coord, 3>{-500'000, -300'000, 300'000}));
  EXPECT_EQ(layers[2][0].up_nm, (std::array<Coord, 3>{-1'500'000, -1'300'000, -700'000}));
}

// 3 * 10^10 facets are counted without memory for them.
TEST(CountFacets, CountsFacesInManyLayers) {
  IndexedMesh mesh = Face({0, 0, 0}, {10 * kMm, 0, 10'000 * kMm}, {0, kMm, 20'000 * kMm});
  mesh.triangles.resize(1'500'000, mesh.triangles.front());
  const IndexedMesh* const meshes[] = {&mesh};
  EXPECT_EQ(CountFacets(meshes, Layers(20'000)), std::vector<int64_t>(20'000, 1'500'000));
}

TEST(LowerCuts, CutsAboveTheBottomButNotTheFirstLayer) {
  std::vector<LayerPlane> planes = Layers(3);
  LowerCuts(50'000, planes);
  EXPECT_EQ(planes[0].z_nm, 500'000);
  EXPECT_EQ(planes[1].z_nm, 1'050'000);
  EXPECT_EQ(planes[2].z_nm, 2'050'000);
  LowerCuts(kMm, planes);
  EXPECT_EQ(planes[1].z_nm, 1'050'000) << "never raised";
}

}  // namespace
}  // namespace slicefarm::slicing::surface_facets_test
