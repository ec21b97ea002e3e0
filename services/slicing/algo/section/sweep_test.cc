#include "services/slicing/algo/section/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/model/limits.h"
#include "common/model/scene/placement.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/topology/mesh_measure.h"

namespace slicefarm::slicing::sweep_test {
namespace {

constexpr Coord kMm = kNmPerMm;

ConnectedMesh Connected(const RawMesh& raw) { return *Connect(*PlaceMesh(raw), {}); }

std::vector<Section> CutAll(const ConnectedMesh& mesh, const std::vector<Coord>& planes) {
  const auto sweep = Sweep::Prepare(mesh, planes);
  EXPECT_TRUE(sweep.ok()) << sweep.status();
  SweepScratch scratch;
  std::vector<Section> sections;
  for (size_t k = 0; k < planes.size(); ++k) sections.push_back(sweep->Cut(k, scratch));
  return sections;
}

std::vector<Coord> Planes(Coord step, Coord top) {
  std::vector<Coord> planes;
  for (Coord z = step / 2; z < top; z += step) planes.push_back(z);
  return planes;
}

double AreaOf(const Section& section) {
  double area = 0;
  for (const Polygon& loop : section.loops) area += SignedArea(loop);
  return area;
}

/// Returns the loops as a set that depends neither on their order nor on their start points.
std::multiset<Polygon> Canonical(const Section& section) {
  std::multiset<Polygon> loops;
  for (Polygon loop : section.loops) {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    loops.insert(std::move(loop));
  }
  return loops;
}

TEST(Sweep, OneRuleAtTheHeightsOfVertices) {
  // Above means z_vertex >= z_plane: at the bottom nothing is cut, at the top everything.
  const std::vector<Section> sections =
      CutAll(Connected(Cube(0, 0, 0)), {-1, 0, 1, 5 * kMm, 10 * kMm, 10 * kMm + 1});
  const std::vector<double> want_mm2 = {0, 0, 100, 100, 100, 0};
  for (size_t k = 0; k < sections.size(); ++k) {
    EXPECT_EQ(AreaOf(sections[k]), want_mm2[k] * 1e12) << k;
    EXPECT_TRUE(sections[k].chains.empty());
  }
}

TEST(Sweep, TetrahedronShrinksAsItShould) {
  const ConnectedMesh mesh = Connected(TetrahedronMesh(12));
  const std::vector<Coord> planes = {1, 3 * kMm, 6 * kMm, 12 * kMm - 2};
  const std::vector<Section> sections = CutAll(mesh, planes);
  for (size_t k = 0; k < planes.size(); ++k) {
    const double side = 12e6 - static_cast<double>(planes[k]);
    EXPECT_NEAR(AreaOf(sections[k]), side * side / 2, 2 * 12e6) << k;
    ASSERT_EQ(sections[k].loops.size(), 1u);
    EXPECT_EQ(sections[k].loops[0].size(), 3u);
  }
}

struct TorusCase {
  std::string name;
  TorusShape shape;
  Coord layer;
};

std::vector<TorusCase> TorusCases() {
  return {{"Plain", {}, 200'000},
          {"Fine", {.around = 300, .sides = 200}, 200'000},
          {"OnThePlanes", {.snap_to_layer = 0.2}, 200'000},
          {"FineOnThePlanes", {.around = 100, .sides = 400, .snap_to_layer = 0.2}, 200'000},
          {"AllOnFewPlanes", {.around = 50, .sides = 300, .snap_to_layer = 4}, 4'000'000}};
}

ConnectedMesh ConnectedTorus(const TorusCase& c) {
  IndexedMesh placed = *PlaceMesh(TorusMesh(c.shape));
  // Placement moves the lowest ring to z = 0, but it should be on the first plane.
  if (c.shape.snap_to_layer > 0)
    for (Vertex& v : placed.vertices) v.z += c.layer / 2;
  return *Connect(std::move(placed), {});
}

TEST(Sweep, ClosedMeshesGiveClosedLoopsEvenThroughVertices) {
  for (const TorusCase& c : TorusCases()) {
    const ConnectedMesh mesh = ConnectedTorus(c);
    const std::vector<Coord> planes = Planes(c.layer, 20 * kMm + c.layer / 2);
    const std::vector<Section> sections = CutAll(mesh, planes);
    for (size_t k = 0; k < planes.size(); ++k) {
      EXPECT_TRUE(sections[k].chains.empty()) << c.name << k;
      const bool first_on_vertices = c.shape.snap_to_layer > 0 && k == 0;
      const bool above = planes[k] > ExtentOf(mesh.mesh).max.z;
      EXPECT_EQ(sections[k].loops.size(), first_on_vertices || above ? 0u : 2u) << c.name << k;
    }
  }
}

TEST(Sweep, TorusHasTheAreaOfItsFormula) {
  const ConnectedMesh mesh = Connected(TorusMesh({.around = 1000, .sides = 500}));
  const std::vector<Coord> planes = Planes(500'000, 20 * kMm);
  const std::vector<Section> sections = CutAll(mesh, planes);
  for (size_t k = 0; k < planes.size(); ++k) {
    const double z = ToMm(static_cast<double>(planes[k])) - 10;
    const double want = 4 * std::numbers::pi * 30 * std::sqrt(100 - z * z);
    EXPECT_NEAR(AreaOf(sections[k]) * 1e-12, want, want * 2e-4 + 0.1) << k;
  }
}

/// Returns the integral of the area. Between two heights with vertices the area is a polynomial of
/// degree 2, which two Gauss points integrate exactly.
double IntegralOfAreaMm3(const ConnectedMesh& mesh) {
  std::set<Coord> heights;
  for (const Vertex& v : mesh.mesh.vertices) heights.insert(v.z);
  std::vector<Coord> planes;
  std::vector<double> weights;
  for (auto low = heights.begin(), high = std::next(low); high != heights.end(); ++low, ++high) {
    const double middle = 0.5 * static_cast<double>(*low + *high);
    const double half = 0.5 * static_cast<double>(*high - *low);
    for (const double side : {-1.0, 1.0}) {
      planes.push_back(std::llround(middle + side * half / std::sqrt(3.0)));
      weights.push_back(half);
    }
  }
  const std::vector<Section> sections = CutAll(mesh, planes);
  double volume = 0;
  for (size_t k = 0; k < planes.size(); ++k) volume += AreaOf(sections[k]) * weights[k];
  return volume * 1e-18;
}

TEST(Sweep, AreasIntegrateToTheVolume) {
  const std::vector<RawMesh> meshes = {
      Cube(0, 0, 0),
      TetrahedronMesh(20),
      TorusMesh({}),
      Mirrored(TorusMesh({.sides = 7})),
      Joined(Cube(0, 0, 0), Cube(10, 10, 0)),
      TurnedInsideOut(Cube(0, 0, 0)),
      Joined(BoxMesh({-5, -5, -5}, {15, 15, 15}), TurnedInsideOut(Cube(0, 0, 0)))};
  for (const RawMesh& raw : meshes) {
    for (const std::array<double, 3>& turn :
         {std::array{0.0, 0.0, 0.0}, {90.0, 0.0, 0.0}, {30.0, 40.0, 50.0}}) {
      const ConnectedMesh mesh = *Connect(*PlaceMesh(raw, TransformOf({.rotate_deg = turn})), {});
      const double volume = VolumeMm3(mesh.mesh);
      EXPECT_NEAR(IntegralOfAreaMm3(mesh), volume, 1e-6 * std::abs(volume));
    }
  }
}

TEST(Sweep, DoesNotDependOnTheOrderOfTriangles) {
  const RawMesh two = Joined(TorusMesh({}), Moved(TorusMesh({.around = 20}), {25, 3, 2}));
  const std::vector<Coord> planes = Planes(300'000, 25 * kMm);
  const std::vector<Section> want = CutAll(Connected(two), planes);
  for (const uint32_t seed : {1u, 2u, 3u}) {
    const std::vector<Section> got = CutAll(Connected(Shuffled(two, seed)), planes);
    for (size_t k = 0; k < planes.size(); ++k) EXPECT_EQ(Canonical(got[k]), Canonical(want[k]));
  }
}

TEST(Sweep, MirrorImagesHaveMirrorSections) {
  const RawMesh torus = Joined(TorusMesh({.around = 17}), Cube(20, 30, 1));
  const std::vector<Coord> planes = Planes(700'000, 20 * kMm);
  const IndexedMesh placed = *PlaceMesh(torus);
  IndexedMesh mirrored = placed;
  for (Vertex& v : mirrored.vertices) v.x = -v.x;
  for (auto& t : mirrored.triangles) std::swap(t[1], t[2]);
  const std::vector<Section> plain = CutAll(*Connect(placed, {}), planes);
  std::vector<Section> images = CutAll(*Connect(mirrored, {}), planes);
  for (size_t k = 0; k < planes.size(); ++k) {
    for (Polygon& loop : images[k].loops) {
      for (Point& p : loop) p.x = -p.x;
      std::reverse(loop.begin(), loop.end());
    }
    EXPECT_EQ(Canonical(images[k]), Canonical(plain[k])) << k;
  }
}

TEST(Sweep, CubesThatTouchInAnEdgeStayApart) {
  const RawMesh cubes = Joined(Cube(0, 0, 0), Cube(10, 10, 0));
  for (const uint32_t seed : {0u, 1u, 2u, 3u, 4u}) {
    const std::vector<Section> sections =
        CutAll(Connected(Shuffled(cubes, seed)), {3 * kMm, 10 * kMm});
    ASSERT_EQ(sections.size(), 2u);
    for (const Section& section : sections) {
      EXPECT_TRUE(section.chains.empty());
      ASSERT_EQ(section.loops.size(), 2u);
      for (const Polygon& loop : section.loops) EXPECT_EQ(SignedArea(loop), 1e14);
    }
  }
}

TEST(Sweep, AFlippedFaceMakesNoDifference) {
  RawMesh flipped = Cube(0, 0, 0);
  std::swap(flipped.triangles[6][0], flipped.triangles[6][1]);
  const std::vector<Coord> planes = Planes(kMm, 10 * kMm);
  const std::vector<Section> want = CutAll(Connected(Cube(0, 0, 0)), planes);
  const std::vector<Section> got = CutAll(Connected(flipped), planes);
  for (size_t k = 0; k < planes.size(); ++k) EXPECT_EQ(Canonical(got[k]), Canonical(want[k]));
}

TEST(Sweep, OpenMeshesGiveChainsThatEndWhereTheSurfaceDoes) {
  // The box has lost both triangles of the side x = 10.
  const RawMesh box = WithoutTriangle(WithoutTriangle(Cube(0, 0, 0), 11), 10);
  const std::vector<Section> sections = CutAll(Connected(box), {4 * kMm});
  EXPECT_TRUE(sections[0].loops.empty());
  ASSERT_EQ(sections[0].chains.size(), 1u);
  const Polyline& chain = sections[0].chains[0];
  EXPECT_EQ(chain.front(), (Point{5 * kMm, 5 * kMm}));
  EXPECT_EQ(chain.back(), (Point{5 * kMm, -5 * kMm}));
  EXPECT_DOUBLE_EQ(Length(chain), 30e6);
}

/// The sweep must handle every closed mesh within the limits: products of two 32-bit differences.
TEST(Sweep, StaysExactAtTheLimits) {
  constexpr Coord kFar = limits::kMaxCoord;
  IndexedMesh mesh;
  mesh.vertices = {{-kFar, -kFar, 0}, {kFar, -kFar, 0}, {0, kFar, 0}, {kFar, kFar, kFar}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const ConnectedMesh connected = *Connect(mesh, {});
  const std::vector<Section> sections = CutAll(connected, {1, kFar / 3, kFar - 1, kFar});
  // The edge from (-kFar, -kFar, 0) to (kFar, kFar, kFar) has x = -kFar + 2 z.
  EXPECT_EQ(Canonical(sections[1]).begin()->front(),
            (Point{-kFar + 2 * (kFar / 3), -kFar + 2 * (kFar / 3)}));
  for (const Section& section : sections) EXPECT_TRUE(section.chains.empty());
}

/// Returns the status for repeated tall needles: every face is in every layer.
absl::Status StatusOfNeedles(size_t faces, size_t layers, int64_t other_points = 0) {
  ConnectedMesh connected;
  connected.mesh.vertices = {{0, 0, 0}, {1'000, 0, 0}, {0, 0, 100'000}};
  connected.mesh.triangles.assign(faces, {0, 1, 2});
  connected.twins.assign(3 * faces, kNoTwin);
  std::vector<Coord> planes(layers);
  for (size_t k = 0; k < layers; ++k) planes[k] = static_cast<Coord>(k + 1);
  return Sweep::Prepare(connected, planes, other_points).status();
}

TEST(Sweep, RefusesMoreThanALayerMayHold) {
  const absl::Status status = StatusOfNeedles(limits::kMaxPointsPerLayer + 1, 1);
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), std::to_string(limits::kMaxPointsPerLayer));
}

TEST(Sweep, RefusesMoreThanAJobMayHold) {
  const absl::Status status = StatusOfNeedles(20'000, 20'000);
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge);
  EXPECT_EQ(DetailOf(status).metadata.at("limit"), std::to_string(limits::kMaxPointsPerJob));
  EXPECT_TRUE(StatusOfNeedles(10, 10, limits::kMaxPointsPerJob - 100).ok());
  EXPECT_EQ(DetailOf(StatusOfNeedles(10, 10, limits::kMaxPointsPerJob - 99)).reason,
            Reason::kMeshTooLarge)
      << "other parts have the room";
}

}  // namespace
}  // namespace slicefarm::slicing::sweep_test
