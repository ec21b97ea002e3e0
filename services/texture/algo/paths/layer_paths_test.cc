#include "services/texture/algo/paths/layer_paths.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::layer_paths_test {
namespace {

EngravePlan PlanOf(SurfaceMap map, const std::string& texture, const EngraveOptions& options,
                   std::optional<HeightGrid> mask = std::nullopt) {
  return *PlanEngraving(std::move(map), *TextureOf(*ComputedHeights(*ParseTextureSpec(texture))),
                        std::move(mask), options);
}

TEST(LayerPaths, LiesAtItsHeightWhereTheTextureIsSolid) {
  const EngravePlan plan = PlanOf(MapFromAbove(FlatSquare(6, 20)), "bumps:height=0.5",
                                  {.layer_height_mm = 0.1, .lines = {{0.2, 0}, {0.3, 90}}});
  const auto paths = LayerPaths(plan, 0, 5);
  ASSERT_TRUE(paths.ok()) << paths.status();
  ASSERT_EQ(paths->size(), 5u);
  for (const LayerPath& path : *paths) {
    EXPECT_GT(path.runs, 25 * 3);
    for (size_t i = 1; i < path.points.size(); ++i) {
      const ToolPoint &from = path.points[i - 1], &to = path.points[i];
      EXPECT_NEAR(to.place_mm.z(), path.height_mm, 1e-12);
      EXPECT_EQ(to.normal, Eigen::Vector3d(0, 0, 1));
      if (!to.on) continue;
      const Eigen::Vector3d middle = (from.place_mm + to.place_mm) / 2;
      const Eigen::Vector2d place = plan.placement.ToTexture(middle.head<2>());
      EXPECT_GT(plan.texture.heights.At(place), path.height_mm - 1e-9) << middle.transpose();
    }
    // The lines cover the section.
    const double area = 25 * path.section_mm2;
    EXPECT_NEAR(path.on_mm * path.spacing_mm, area, 0.12 * area) << path.layer;
  }
}

TEST(LayerPaths, ARangeOfLayersIsThatPartOfAll) {
  const EngravePlan plan = PlanOf(FlatMapOf(Cap(8, 0)), "knurl:height=0.05,pitch=0.4",
                                  {.layer_height_mm = 0.01, .lines = {{0.03, 0}, {0.03, 60}}});
  const auto all = LayerPaths(plan, 0, 5), some = LayerPaths(plan, 2, 4);
  ASSERT_TRUE(all.ok() && some.ok());
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ((*all)[2 + i].points.size(), (*some)[i].points.size());
    for (size_t k = 0; k < (*some)[i].points.size(); ++k)
      EXPECT_EQ((*all)[2 + i].points[k].place_mm, (*some)[i].points[k].place_mm);
  }
}

TEST(LayerPaths, LinksStayOrPassAbove) {
  const auto link_heights = [](double clearance) {
    const EngravePlan plan = PlanOf(
        MapFromAbove(FlatSquare(6, 20)), "cones:height=0.4",
        {.layer_height_mm = 0.4, .lines = {{0.3, 0}}, .engraved = true, .clearance_mm = clearance});
    double low = 1e9, high = -1e9;
    const auto paths = LayerPaths(plan, 0, 1);
    for (const ToolPoint& point : (*paths)[0].points) {
      low = std::min(low, point.place_mm.z());
      high = std::max(high, point.place_mm.z());
      if (point.on) {
        EXPECT_NEAR(point.place_mm.z(), -0.2, 1e-12);
      }
    }
    return std::pair(low, high);
  };
  EXPECT_EQ(link_heights(0), std::pair(-0.2, -0.2));
  EXPECT_EQ(link_heights(1.5), std::pair(-0.2, 1.5));
}

TEST(LayerPaths, KeepToMargins) {
  const EngravePlan plan =
      PlanOf(MapFromAbove(SquareWithHole(10, 20)), "waves:height=0.4",
             {.layer_height_mm = 0.4, .lines = {{0.25, 30}}, .margin_mm = 1.5});
  const auto paths = LayerPaths(plan, 0, 1);
  double nearest = 1e9;
  for (size_t i = 1; i < (*paths)[0].points.size(); ++i) {
    if (!(*paths)[0].points[i].on) continue;
    for (const size_t k : {i - 1, i}) {
      const Eigen::Vector2d p = (*paths)[0].points[k].place_mm.head<2>();
      nearest = std::min({nearest, p.minCoeff(), 20 - p.maxCoeff()});
    }
  }
  EXPECT_NEAR(nearest, 1.5, 1e-6);
}

TEST(LayerPaths, KeepToMasks) {
  const HeightGrid left_half{40, 2, {1, 1}, [] {
                               std::vector<double> heights(80, 0.0);
                               for (int i = 0; i < 80; ++i) heights[i] = i % 40 < 20;
                               return heights;
                             }()};
  const EngravePlan plan = PlanOf(MapFromAbove(FlatSquare(10, 20)), "waves:height=0.4",
                                  {.layer_height_mm = 0.4, .lines = {{0.25, 0}}}, left_half);
  const auto paths = LayerPaths(plan, 0, 1);
  EXPECT_GT((*paths)[0].on_mm, 100);
  for (const ToolPoint& point : (*paths)[0].points)
    if (point.on) {
      EXPECT_LT(point.place_mm.x(), 10);
    }
}

TEST(LayerPaths, TellWhereALiftTurnsBack) {
  // The surface is a valley of 90 degrees, where the offsets of its sides meet.
  const SurfaceMesh valley = GridSurface(
      40, [](double x, double y) { return Eigen::Vector3d(8 * x, 8 * y, std::abs(8 * x - 4)); });
  const auto folds = [&](const std::string& texture) {
    const EngravePlan plan =
        PlanOf(MapFromAbove(valley), texture,
               {.placement = {.anchor_mm = Eigen::Vector3d(2, 4, 2)},  // high where the valley is
                .layer_height_mm = 10,
                .lines = {{0.3, 0}}});
    const auto paths = LayerPaths(plan, 0, 1);
    if ((*paths)[0].folds > 0) {
      EXPECT_NEAR((*paths)[0].first_fold_mm.x(), 4, 0.3);
    }
    return (*paths)[0].folds;
  };
  EXPECT_EQ(folds("waves:height=0.05"), 0);
  EXPECT_GT(folds("waves:height=2"), 10);
}

TEST(LayerPaths, RefusesTooManyLinesAndCanBeCancelled) {
  const EngravePlan plan = PlanOf(MapFromAbove(FlatSquare(4, 1000)), "waves:height=0.4",
                                  {.layer_height_mm = 0.4, .lines = {{0.001, 0}}});
  EXPECT_EQ(DetailOf(LayerPaths(plan, 0, 1).status()).reason, Reason::kRequestTooLarge);
  const EngravePlan small = PlanOf(MapFromAbove(FlatSquare(4, 10)), "waves", {});
  EXPECT_EQ(DetailOf(LayerPaths(small, 0, 1, CancelToken([] { return true; })).status()).reason,
            Reason::kCancelled);
}

}  // namespace
}  // namespace slicefarm::texture::layer_paths_test
