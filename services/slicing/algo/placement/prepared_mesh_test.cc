#include "services/slicing/algo/placement/prepared_mesh.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing {
namespace {

absl::StatusOr<PreparedMesh> Prepare(std::string bytes, const Placement& placement = {}) {
  return PrepareMesh({"part.stl", MeshFormat::kUnknown, std::move(bytes)}, *MakeDirectMeshSource(),
                     placement, {}, {});
}

TEST(PrepareMesh, PutsOneCopyInTheMiddleOfTheBed) {
  const auto mesh = Prepare(ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30})));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  ASSERT_EQ(mesh->centers.size(), 1u);
  EXPECT_EQ(mesh->centers[0], (Point{125 * kNmPerMm, 105 * kNmPerMm}));
  EXPECT_EQ(mesh->report.name, "part.stl");
  EXPECT_EQ(mesh->report.min_mm, (std::array<double, 3>{120, 95, 0}));
  EXPECT_EQ(mesh->report.max_mm, (std::array<double, 3>{130, 115, 30}));
}

/// Corners that differ by less than a nanometre: open in the file, closed once rounded.
TEST(PrepareMesh, ReportsTheFileAndSlicesTheRounding) {
  RawMesh box = BoxMesh({0, 0, 0}, {10, 20, 30});
  box.positions.push_back({0, 0, 6.9e-15});
  for (auto& corner : box.triangles[0]) corner = corner == 0 ? 8 : corner;
  const auto mesh = Prepare(ToBinaryStl(box));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->report.vertices, 9);
  EXPECT_EQ(mesh->report.open_edges, 4);
  EXPECT_FALSE(mesh->report.Closed());
  EXPECT_TRUE(mesh->connected.closed);
}

TEST(PrepareMesh, PassesTheErrorsOn) {
  const std::string box = ToBinaryStl(BoxMesh({0, 0, 0}, {10, 20, 30}));
  EXPECT_EQ(DetailOf(Prepare(box.substr(0, 100)).status()).reason, Reason::kMeshTruncated);
  EXPECT_EQ(DetailOf(Prepare(box, {.unit_mm = -1}).status()).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(Prepare(box, {.unit_mm = 25.4}).status()).reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(DetailOf(Prepare(box, {.unit_mm = 1000}).status()).reason, Reason::kOutOfRange);
  EXPECT_EQ(DetailOf(Prepare(box, {.scale = {1e-8, 1e-8, 1e-8}}).status()).reason,
            Reason::kMeshEmpty);
}

}  // namespace
}  // namespace slicefarm::slicing
