#include "services/slicing/algo/placement/orientation/orientation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <string>

#include "common/base/error.h"
#include "common/model/scene/rotation.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "tests/corpus_file.h"

namespace slicefarm::slicing::orientation_test {
namespace {

IndexedMesh Placed(const RawMesh& raw, std::array<double, 3> rotate_deg = {0, 0, 0}) {
  Placement placement;
  placement.rotate_deg = rotate_deg;
  return *PlaceMesh(raw, TransformOf(placement));
}

OrientationSuggestion SuggestOrDie(const IndexedMesh& mesh) {
  absl::StatusOr<OrientationSuggestion> suggestion = SuggestOrientation(mesh, {}, {});
  EXPECT_TRUE(suggestion.ok()) << suggestion.status();
  EXPECT_FALSE(suggestion->best.empty());
  return *suggestion;
}

/// Returns a cone that stands on its base or on its tip.
RawMesh Cone(double radius, double height, int sides, bool on_tip = false) {
  RawMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const auto [s, c] = SineCosineDegrees(360.0 * i / sides);
    mesh.positions.push_back({radius * c, radius * s, on_tip ? height : 0});
  }
  const uint32_t middle = sides, tip = sides + 1;
  mesh.positions.push_back({0, 0, on_tip ? height : 0});
  mesh.positions.push_back({0, 0, on_tip ? 0 : height});
  for (uint32_t i = 0; i < middle; ++i) {
    const uint32_t next = (i + 1) % middle;
    mesh.triangles.push_back({next, i, middle});
    mesh.triangles.push_back({i, next, tip});
  }
  return on_tip ? TurnedInsideOut(mesh) : mesh;
}

/// Returns a post of 10 x 60 x 30 under a bar of 50 x 60 x 10.
RawMesh Tee() {
  return Joined(BoxMesh({-5, -30, 0}, {5, 30, 30}), BoxMesh({-25, -30, 30}, {25, 30, 40}));
}

TEST(SuggestOrientation, LaysAnAskewBoxOnItsLargestFace) {
  const IndexedMesh askew = Placed(BoxMesh({0, 0, 0}, {60, 40, 10}), {33, 71, -20});
  const OrientationSuggestion suggestion = SuggestOrDie(askew);
  EXPECT_FALSE(suggestion.current.stable);
  EXPECT_GT(suggestion.current.overhang_mm2, 100);
  const PrintOrientation& best = suggestion.best[0];
  EXPECT_TRUE(best.stable);
  EXPECT_NEAR(best.height_mm, 10, 1e-4);
  EXPECT_NEAR(best.footprint_mm2, 2400, 0.01);
  EXPECT_NEAR(best.contact_mm2, 2400, 0.01);
  EXPECT_NEAR(best.overhang_mm2, 0, 1e-9);
  EXPECT_LT(best.score, suggestion.current.score);
}

TEST(SuggestOrientation, LeavesABoxThatLiesWell) {
  const OrientationSuggestion suggestion = SuggestOrDie(Placed(BoxMesh({0, 0, 0}, {60, 40, 10})));
  EXPECT_EQ(suggestion.best[0].rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(suggestion.best[0].score, suggestion.current.score);
}

TEST(SuggestOrientation, TurnsATeeOver) {
  const OrientationSuggestion suggestion = SuggestOrDie(Placed(Tee()));
  // The overhang is both wings, and the bar's underside above the post: it and the post's hidden
  // top face each other.
  EXPECT_NEAR(suggestion.current.overhang_mm2, 50 * 60, 1);
  EXPECT_TRUE(suggestion.current.stable);
  const PrintOrientation& best = suggestion.best[0];
  EXPECT_NEAR(best.contact_mm2, 3000, 1);
  EXPECT_NEAR((best.rotation * Eigen::Vector3d::UnitZ()).z(), -1, 1e-9);
}

TEST(SuggestOrientation, PutsAConeOnItsBase) {
  const OrientationSuggestion suggestion = SuggestOrDie(Placed(Cone(20, 40, 90, true)));
  EXPECT_FALSE(suggestion.current.stable);
  const PrintOrientation& best = suggestion.best[0];
  EXPECT_NEAR(best.contact_mm2, M_PI * 400, 2);
  EXPECT_NEAR(best.height_mm, 40, 1e-6);
  EXPECT_EQ(best.overhang_mm2, 0);
}

TEST(SuggestOrientation, MeasuresOverhangsBySlope) {
  // The cone stands on its tip and is 45 degrees steep; it needs support for angles from 46
  // degrees.
  const IndexedMesh mesh = Placed(Cone(20, 20, 360, true));
  const auto overhang = [&](double deg) {
    return SuggestOrientation(mesh, {.overhang_deg = deg}, {})->current.overhang_mm2;
  };
  EXPECT_EQ(overhang(44), 0);
  EXPECT_NEAR(overhang(46), M_PI * 400, 1);
}

TEST(SuggestOrientation, GivesRotations) {
  const auto best = SuggestOrDie(Placed(Tee(), {20, 50, 80})).best;
  ASSERT_FALSE(best.empty());
  for (const PrintOrientation& o : best) {
    EXPECT_NEAR((o.rotation * o.rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 0,
                1e-12);
    EXPECT_NEAR(o.rotation.determinant(), 1, 1e-12);
    EXPECT_TRUE(RotationXyz(AnglesXyzDegrees(o.rotation)).isApprox(o.rotation, 1e-7));
  }
}

TEST(AnglesXyzDegrees, UndoesRotationXyz) {
  for (const std::array<double, 3> angles : {std::array{0.0, 0.0, 0.0},
                                             {30.0, 40.0, 50.0},
                                             {180.0, 0.0, 0.0},
                                             {0.0, 90.0, 20.0},
                                             {10.0, -90.0, 0.0},
                                             {-170.0, 12.0, 99.0}}) {
    const Eigen::Matrix3d want = RotationXyz(angles);
    EXPECT_TRUE(RotationXyz(AnglesXyzDegrees(want)).isApprox(want, 1e-7));
  }
}

TEST(SuggestOrientation, RefusesWhatCannotBe) {
  EXPECT_EQ(DetailOf(SuggestOrientation({}, {}, {}).status()).reason, Reason::kMeshEmpty);
  const IndexedMesh line = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(DetailOf(SuggestOrientation(line, {}, {}).status()).reason, Reason::kMeshEmpty);
  const IndexedMesh box = Placed(Cube(0, 0, 0));
  EXPECT_EQ(DetailOf(SuggestOrientation(box, {.overhang_deg = NAN}, {}).status()).reason,
            Reason::kSettingOutOfRange);
  const CancelToken cancelled([] { return true; });
  EXPECT_EQ(SuggestOrientation(box, {}, cancelled).status().code(), absl::StatusCode::kCancelled);
}

TEST(SuggestOrientation, TakesAFlatMesh) {
  const IndexedMesh sheet = {{{0, 0, 0}, {9'000'000, 0, 0}, {0, 9'000'000, 0}}, {{0, 1, 2}}};
  EXPECT_TRUE(SuggestOrDie(sheet).best[0].stable);
}

TEST(SuggestOrientation, DoesNotDependOnTheOrderOfTriangles) {
  const RawMesh torus = TorusMesh({});
  const OrientationSuggestion a = SuggestOrDie(Placed(torus, {50, 0, 0}));
  const OrientationSuggestion b = SuggestOrDie(Placed(Shuffled(torus, 7), {50, 0, 0}));
  EXPECT_NEAR(a.best[0].score, b.best[0].score, 1e-9);
  EXPECT_NEAR(a.best[0].height_mm, 20, 0.2);
}

TEST(SuggestOrientation, HandlesAMillionTriangles) {
  const IndexedMesh mesh = Placed(TorusMesh({.around = 1000, .sides = 500}), {50, 20, 0});
  ASSERT_EQ(mesh.triangles.size(), 1'000'000u);
  const auto begin = std::chrono::steady_clock::now();
  const OrientationSuggestion suggestion = SuggestOrDie(mesh);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds", std::to_string(took.count()));
  EXPECT_LT(took.count(), 10);
  EXPECT_NEAR(suggestion.best[0].height_mm, 20, 0.2);
}

IndexedMesh FromCorpus(const char* name, std::array<double, 3> rotate_deg) {
  const std::string bytes = CorpusFile(std::string("models/").append(name));
  return Placed(*ReadMesh(bytes, MeshFormat::kUnknown, 1e6, {}), rotate_deg);
}

TEST(SuggestOrientation, PutsTheCorpusOnItsFeet) {
  for (const char* name : {"benchy.stl", "busted.stl", "featuretype.stl", "textbox.stl"}) {
    SCOPED_TRACE(name);
    const PrintOrientation printed = SuggestOrDie(FromCorpus(name, {0, 0, 0})).current;
    const OrientationSuggestion askew = SuggestOrDie(FromCorpus(name, {117, 40, 5}));
    EXPECT_LE(askew.best[0].score, printed.score + 1e-3);
    EXPECT_LT(askew.best[0].score, askew.current.score);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::orientation_test
