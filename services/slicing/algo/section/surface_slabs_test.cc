#include "services/slicing/algo/section/surface_slabs.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::slicing::surface_slabs_test {
namespace {

constexpr Coord kMm = kNmPerMm;
using Faces = SurfaceSlabs::Faces;

/// Returns a slope of 10 mm x 10 mm that rises by 5 mm along x.
IndexedMesh Slope() {
  IndexedMesh mesh;
  mesh.vertices = {
      {0, 0, 0}, {10 * kMm, 0, 5 * kMm}, {10 * kMm, 10 * kMm, 5 * kMm}, {0, 10 * kMm, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

TEST(SurfaceSlabs, EachHasItsStrip) {
  const IndexedMesh mesh = Slope();
  const SurfaceSlabs slabs(mesh, {{0, kMm}, {kMm, 4 * kMm}, {4 * kMm, 9 * kMm}}, Faces::kAll);
  EXPECT_NEAR(Mm2(slabs.Shadow(0, 0)), 20, 1e-6);
  EXPECT_NEAR(Mm2(slabs.Shadow(1, 0)), 60, 1e-6);
  EXPECT_NEAR(Mm2(slabs.Shadow(2, 0)), 20, 1e-6);
  EXPECT_EQ(Bounds(slabs.Shadow(1, 0)).min, (Point{2 * kMm, 0}));
}

/// The orientation of a face and the order of faces change nothing.
TEST(SurfaceSlabs, DoesNotAskWhichSideIsUp) {
  IndexedMesh mesh = Slope();
  const MultiPolygon want = SurfaceSlabs(mesh, {{kMm, 2 * kMm}}, Faces::kAll).Shadow(0, kMm / 10);
  std::swap(mesh.triangles[0], mesh.triangles[1]);
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_EQ(SurfaceSlabs(mesh, {{kMm, 2 * kMm}}, Faces::kAll).Shadow(0, kMm / 10), want);
}

TEST(SurfaceSlabs, LevelFacesAloneAreWhatPlanesDoNotCut) {
  IndexedMesh mesh = Slope();
  EXPECT_TRUE(SurfaceSlabs(mesh, {{0, 5 * kMm}}, Faces::kLevelAlone).Shadow(0, 0).empty());
  for (Vertex& v : mesh.vertices) v.z = 2 * kMm;
  const SurfaceSlabs slabs(mesh, {{0, 2 * kMm}, {2 * kMm, 3 * kMm}, {3 * kMm, 4 * kMm}},
                           Faces::kLevelAlone);
  EXPECT_NEAR(Mm2(slabs.Shadow(0, 0)), 100, 1e-6) << "the top of one slab";
  EXPECT_NEAR(Mm2(slabs.Shadow(1, 0)), 100, 1e-6) << "and the bottom of the next";
  EXPECT_TRUE(slabs.Shadow(2, 0).empty());
}

/// Adds a level rectangle of two faces, in mm.
void AddLevel(double x0, double y0, double x1, double y1, IndexedMesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const auto& [x, y] : {std::pair{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})
    mesh.vertices.push_back({FromMm(x), FromMm(y), kMm});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// The painted area is like one from a brush: a disc of cells of 0.04 mm, with small holes in it.
TEST(SurfaceSlabs, StairsOfPaintAreAsIfUnitedAtOnce) {
  IndexedMesh mesh;
  std::vector<Polygon> cells;
  for (int x = -50; x < 50; ++x)
    for (int y = -50; y < 50; ++y)
      if (x * x + y * y < 50 * 50 && (x % 7 != 3 || y % 7 != 3)) {
        AddLevel(x * 0.04, y * 0.04, (x + 1) * 0.04, (y + 1) * 0.04, mesh);
        const Coord cell = 40'000;
        cells.push_back({{x * cell, y * cell},
                         {(x + 1) * cell, y * cell},
                         {(x + 1) * cell, (y + 1) * cell},
                         {x * cell, (y + 1) * cell}});
      }
  const Coord reach = kMm / 10;
  const MultiPolygon got = SurfaceSlabs(mesh, {{0, 2 * kMm}}, Faces::kAll).Shadow(0, reach);
  const MultiPolygon want = FastOffset(Union(cells, FillRule::kNonZero), reach);
  ASSERT_EQ(got.size(), 1u);
  EXPECT_TRUE(got[0].holes.empty());
  EXPECT_LT(Mm2(Difference(want, got)) + Mm2(Difference(got, want)), 2 * 3.15 * 2.1 * 0.005);
}

TEST(SurfaceSlabs, StripsOfAMicrometreHaveAReach) {
  IndexedMesh mesh;
  AddLevel(0, 0, 10, 0.001, mesh);
  const MultiPolygon got = SurfaceSlabs(mesh, {{0, 2 * kMm}}, Faces::kAll).Shadow(0, kMm / 10);
  EXPECT_NEAR(Mm2(got), 10.2 * 0.201, 0.01);
}

TEST(SurfaceSlabs, UprightFacesHaveNoShadow) {
  IndexedMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10 * kMm, 0, 0}, {10 * kMm, 0, 5 * kMm}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(SurfaceSlabs(mesh, {{0, 9 * kMm}}, Faces::kAll).Shadow(0, kMm).empty());
}

}  // namespace
}  // namespace slicefarm::slicing::surface_slabs_test
