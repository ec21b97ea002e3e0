#include "services/slicing/algo/placement/orientation/orientation_advice.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/scene/placement.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::orientation_advice_test {
namespace {

std::optional<OrientationAdvice> Advice(const RawMesh& raw, const Placement& placement = {}) {
  const Transform to_plate = TransformOf(placement);
  const IndexedMesh mesh = *PlaceMesh(raw, to_plate);
  const IndexedMesh* parts[] = {&mesh};
  const auto advice = AdviseOrientation(parts, to_plate, {});
  EXPECT_TRUE(advice.ok()) << advice.status();
  return advice.value_or(std::nullopt);
}

RawMesh Plank() { return BoxMesh({0, 0, 0}, {60, 40, 5}); }

TEST(AdviseOrientation, HasNothingToSayOfWhatLiesWell) {
  EXPECT_FALSE(Advice(Plank()).has_value());
}

TEST(AdviseOrientation, LaysAPlankDown) {
  Placement on_edge;
  on_edge.rotate_deg = {90, 0, 0};
  const auto advice = Advice(Plank(), on_edge);
  ASSERT_TRUE(advice.has_value());
  EXPECT_NEAR(advice->asked.contact_mm2, 300, 1e-3);
  EXPECT_NEAR(advice->asked.height_mm, 40, 1e-6);
  EXPECT_NEAR(advice->advised.contact_mm2, 2400, 1e-3);
  EXPECT_NEAR(advice->advised.height_mm, 5, 1e-6);
  EXPECT_NEAR(advice->advised.overhang_mm2, 0, 1e-6);
  EXPECT_TRUE(advice->advised.stable);
}

// The advised angles replace the current ones, with or without scaling.
TEST(AdviseOrientation, ItsAnglesLayTheObjectSo) {
  for (const std::array<double, 3> scale : {std::array<double, 3>{1, 1, 1}, {2, 1, 0.5}}) {
    for (const std::array<double, 3> turned :
         {std::array<double, 3>{90, 0, 0}, {0, 90, 0}, {33, 71, -20}}) {
      Placement placement;
      placement.scale = scale;
      placement.rotate_deg = turned;
      const auto advice = Advice(Plank(), placement);
      ASSERT_TRUE(advice.has_value());
      placement.rotate_deg = advice->rotate_deg;
      const Extent extent = ExtentOf(*PlaceMesh(Plank(), TransformOf(placement)));
      EXPECT_NEAR(ToMm(static_cast<double>(extent.max.z - extent.min.z)), 5 * scale[2], 1e-3);
      EXPECT_FALSE(Advice(Plank(), placement).has_value()) << "once is enough";
    }
  }
}

TEST(AdviseOrientation, HasNoAnglesForWhatIsMirroredOrSheared) {
  const IndexedMesh upright = *PlaceMesh(BoxMesh({0, 0, 0}, {60, 5, 40}));
  const IndexedMesh* parts[] = {&upright};
  Transform to_plate = Transform::Identity();
  EXPECT_TRUE(AdviseOrientation(parts, to_plate, {})->has_value());
  to_plate(0, 0) = -1;
  EXPECT_FALSE(AdviseOrientation(parts, to_plate, {})->has_value());
  to_plate = Transform::Identity();
  to_plate(0, 1) = 0.5;
  EXPECT_FALSE(AdviseOrientation(parts, to_plate, {})->has_value());
}

TEST(AdviseOrientation, LooksAtAllPartsTogether) {
  const IndexedMesh left = *PlaceMesh(BoxMesh({0, 0, 0}, {5, 40, 60}));
  IndexedMesh right = left;
  for (Vertex& vertex : right.vertices) vertex.y += FromMm(40);
  const IndexedMesh* parts[] = {&left, &right};
  const auto advice = AdviseOrientation(parts, Transform::Identity(), {});
  ASSERT_TRUE(advice.ok() && advice->has_value());
  EXPECT_NEAR((*advice)->advised.height_mm, 5, 1e-6);
  EXPECT_NEAR((*advice)->advised.contact_mm2, 4800, 1e-3);
}

TEST(AdviseOrientation, ErrorsAreThoseOfTheMesh) {
  const IndexedMesh nothing;
  const IndexedMesh* parts[] = {&nothing};
  EXPECT_EQ(DetailOf(AdviseOrientation(parts, Transform::Identity(), {}).status()).reason,
            Reason::kMeshEmpty);
  const IndexedMesh plank = *PlaceMesh(Plank());
  parts[0] = &plank;
  EXPECT_TRUE(absl::IsCancelled(
      AdviseOrientation(parts, Transform::Identity(), CancelToken([] { return true; })).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::orientation_advice_test
