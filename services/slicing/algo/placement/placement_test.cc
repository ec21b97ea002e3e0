#include "services/slicing/algo/placement/placement.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "common/base/error.h"
#include "common/model/scene/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::placement_test {
namespace {

RawMesh Box() { return BoxMesh({5, 5, 5}, {15, 25, 35}); }

Vertex SizeOf(const IndexedMesh& mesh) {
  const auto [min, max] = ExtentOf(mesh);
  return {max.x - min.x, max.y - min.y, max.z - min.z};
}

struct Case {
  const char* name;
  Placement placement;
  Vertex want_mm;
};

TEST(PlaceMesh, ScalesAndTurnsAndStandsOnTheBed) {
  const std::vector<Case> cases = {
      {"AsIs", {}, {10, 20, 30}},
      {"Inches", {.unit_mm = 25.4}, {254, 508, 762}},
      {"Scale", {.scale = {1, 2, 0.5}}, {10, 40, 15}},
      {"AboutX", {.rotate_deg = {90, 0, 0}}, {10, 30, 20}},
      {"AboutY", {.rotate_deg = {0, -90, 0}}, {30, 20, 10}},
      {"AboutZ", {.rotate_deg = {0, 0, 270}}, {20, 10, 30}},
      {"ScaleThenTurn", {.scale = {2, 1, 1}, .rotate_deg = {0, 0, 90}}, {20, 20, 30}},
  };
  for (const Case& c : cases) {
    const auto mesh = PlaceMesh(Box(), TransformOf(c.placement));
    ASSERT_TRUE(mesh.ok()) << c.name << mesh.status();
    const Vertex size = SizeOf(*mesh);
    EXPECT_EQ(size,
              (Vertex{c.want_mm.x * kNmPerMm, c.want_mm.y * kNmPerMm, c.want_mm.z * kNmPerMm}))
        << c.name;
    const auto [min, max] = ExtentOf(*mesh);
    EXPECT_EQ(min.z, 0) << c.name;
    EXPECT_EQ(min.x, -max.x) << c.name;
    EXPECT_EQ(min.y, -max.y) << c.name;
  }
}

TEST(PlaceMesh, RoundsHalvesAwayFromZeroSoThatMirrorImagesStay) {
  // floor(x + 0.5) would round -2.5 to -2 but 2.5 to 3, and 0.49999999999999994 to 1. The case is
  // an exercise of the book on robustness.
  for (const double nm : {2.5, 0.49999999999999994, 1.5, 12345.5}) {
    const RawMesh raw = {{{nm * 1e-6, 0, 0}, {-nm * 1e-6, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const auto mesh = PlaceMesh(raw);
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(mesh->vertices[0].x, -mesh->vertices[1].x) << nm;
  }
}

TEST(PlaceMesh, WeldsWhatRoundsToTheSameNanometre) {
  const RawMesh raw = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-15, 0, 0}}, {{0, 1, 2}, {3, 2, 1}}};
  const auto mesh = PlaceMesh(raw);
  ASSERT_TRUE(mesh.ok());
  EXPECT_EQ(mesh->vertices.size(), 3u);
  EXPECT_EQ(mesh->triangles[1][0], mesh->triangles[0][0]);
}

TEST(PlaceMesh, FarFromTheOriginIsFineIfThePartIsSmall) {
  const auto mesh = PlaceMesh(Moved(Box(), {9000, -9000, 9000}));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(SizeOf(*mesh), (Vertex{10'000'000, 20'000'000, 30'000'000}));
}

TEST(PlaceMesh, RefusesWhatDoesNotFitTheNumbers) {
  const auto high = PlaceMesh(BoxMesh({0, 0, 0}, {1, 1, 2101}));
  EXPECT_EQ(DetailOf(high.status()).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(high.status()).metadata.at("limit"), "2100.000");
  EXPECT_EQ(DetailOf(high.status()).metadata.at("got"), "2101.000");
  EXPECT_TRUE(PlaceMesh(BoxMesh({0, 0, 0}, {4200, 4200, 2100})).ok());
  EXPECT_FALSE(PlaceMesh(BoxMesh({0, 0, 0}, {4201, 1, 1})).ok());
  const auto huge = PlaceMesh(Box(), TransformOf({.scale = {1e300, 1e300, 1}}));
  EXPECT_EQ(DetailOf(huge.status()).reason, Reason::kOutOfRange);
}

// A mirror reverses each triangle, so the order of its corners must change. Otherwise the mesh
// would be inside out.
TEST(TransformMesh, KeepsTheOutsideOutOfMirrorImages) {
  const auto volume = [](const Transform& transform) {
    const IndexedMesh mesh = *TransformMesh(Box(), transform);
    double six = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto at = [&](uint32_t i) {
        const Vertex& v = mesh.vertices[i];
        return Eigen::Vector3d(ToMm(static_cast<double>(v.x)), ToMm(static_cast<double>(v.y)),
                               ToMm(static_cast<double>(v.z)));
      };
      six += at(a).dot(at(b).cross(at(c)));
    }
    return six / 6;
  };
  Transform mirror = Transform::Identity();
  EXPECT_NEAR(volume(mirror), 6000, 1e-6);
  mirror(1, 1) = -1;
  EXPECT_NEAR(volume(mirror), 6000, 1e-6);
}

TEST(ToOrigin, LeavesWhatIsSunkBelowTheBed) {
  EXPECT_EQ(ToOrigin({{0, 10, 20}, {10, 20, 40}}, 5), (Vertex{-5, -15, -25}));
}

}  // namespace
}  // namespace slicefarm::slicing::placement_test
