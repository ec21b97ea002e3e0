#include "services/slicing/algo/section/surface_slabs.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"

namespace slicefarm::slicing::surface_slabs_test {
namespace {

constexpr Coord kMm = kNmPerMm;
using Faces = SurfaceSlabs::Faces;

/// 10 mm x 10 mm that rise by 5 mm along x.
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

/// The sense of a face and the order of faces change nothing.
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

TEST(SurfaceSlabs, UprightFacesHaveNoShadow) {
  IndexedMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10 * kMm, 0, 0}, {10 * kMm, 0, 5 * kMm}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(SurfaceSlabs(mesh, {{0, 9 * kMm}}, Faces::kAll).Shadow(0, kMm).empty());
}

}  // namespace
}  // namespace slicefarm::slicing::surface_slabs_test
