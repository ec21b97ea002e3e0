#include "services/texture/algo/paths/placement.h"

#include <gtest/gtest.h>

#include "common/model/scene/placement.h"
#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::placement_test {
namespace {

TEST(Placement, BeginsInTheMiddleOfTheMap) {
  const SurfaceMap map = MapFromAbove(FlatSquare(4, 8));
  const Placement placement = PlacementOn(map, {}, {2, 2});
  EXPECT_LT(placement.ToTexture({4, 4}).norm(), 1e-12);
  EXPECT_LT((placement.ToTexture({5, 3}) - Eigen::Vector2d(1, -1)).norm(), 1e-12);
}

TEST(Placement, IsAnchoredTurnedAndScaled) {
  const SurfaceMap map = MapFromAbove(FlatSquare(4, 8));
  const Placement placement = PlacementOn(
      map,
      {.anchor_mm = Eigen::Vector3d(1, 2, 30), .direction = Eigen::Vector3d(0, 5, 1), .scale = 2},
      {2, 2});
  EXPECT_LT(placement.ToTexture({1, 2}).norm(), 1e-12);
  EXPECT_LT((placement.ToTexture({1, 6}) - Eigen::Vector2d(2, 0)).norm(), 1e-12);
  EXPECT_LT((placement.ToTexture({-3, 2}) - Eigen::Vector2d(0, 2)).norm(), 1e-12);
  const Placement turned = PlacementOn(map, {.turn_deg = 90, .middle = true}, {2, 6});
  EXPECT_LT((turned.ToTexture({4, 4}) - Eigen::Vector2d(1, 3)).norm(), 1e-12);
  EXPECT_LT((turned.ToTexture({4, 5}) - Eigen::Vector2d(2, 3)).norm(), 1e-12);
}

TEST(Placement, AnUprightDirectionFallsBack) {
  const SurfaceMap map = MapFromAbove(FlatSquare(4, 8));
  EXPECT_EQ(PlacementOn(map, {.direction = Eigen::Vector3d(0, 0, 1)}, {1, 1}).x_axis,
            Eigen::Vector2d(1, 0));
}

/// On a cylinder, a direction around it stays such a direction for each rotation of the map.
TEST(Placement, FollowsTheSurface) {
  const SurfaceMap map = FlatMapOf(HalfCylinder(16, 5, 12));
  const Eigen::Vector3d top(0, 6, 5);
  const Placement placement =
      PlacementOn(map, {.anchor_mm = top, .direction = Eigen::Vector3d(1, 0, 0)}, {1, 1});
  const auto texture = [&](const Eigen::Vector3d& p) {
    return placement.ToTexture(map.MapPosition(map.NearestTo(p)));
  };
  EXPECT_LT(texture(top).norm(), 1e-9);
  EXPECT_NEAR(texture({0, 8, 5}).y(), 2, 1e-3);
  EXPECT_NEAR(texture({5, 6, 0}).x(), 5 * std::numbers::pi / 2, 0.05);
}

}  // namespace
}  // namespace slicefarm::texture::placement_test
