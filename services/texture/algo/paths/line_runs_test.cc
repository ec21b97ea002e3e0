#include "services/texture/algo/paths/line_runs.h"

#include <gtest/gtest.h>

#include "services/texture/algo/paths/line_field.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::line_runs_test {
namespace {

TEST(RunsOf, ALineCrossesRidges) {
  const SurfaceMap map = MapFromAbove(FlatSquare(7, 20));
  // The texture is solid from 1 to 3 of each 4 mm at half height.
  const Texture ridges = *TextureOf(
      *ComputedHeights(*ParseTextureSpec("grooves:height=1,pitch=4,size=0.6,slope=0.1,detail=80")));
  const auto sections = SectionsOf(ridges, std::array{0.5});
  const WorkArea area{TiledSection(sections[0], ridges.tile_mm, Placement{}), false, {}, nullptr};
  const double levels[] = {4.3};
  const auto sets = LevelLines(map, StraightField(map, {1, 0}), levels);
  ASSERT_TRUE(sets.ok());
  const auto runs = RunsOf(map, (*sets)[0].lines[0], area, 0);
  ASSERT_EQ(runs.size(), 5u);
  for (size_t i = 0; i < runs.size(); ++i) {
    EXPECT_NEAR(map.Position(runs[i].front()).x(), 4.0 * i + 1, 1e-9);
    EXPECT_NEAR(map.Position(runs[i].back()).x(), 4.0 * i + 3, 1e-9);
    for (const SurfacePoint& p : runs[i]) EXPECT_NEAR(map.Position(p).y(), 4.3, 1e-12);
  }
  EXPECT_TRUE(RunsOf(map, (*sets)[0].lines[0], area, 2.1).empty()) << "all are shorter";
}

TEST(RunsOf, ALineAlongARidgeIsWhole) {
  const SurfaceMap map = MapFromAbove(FlatSquare(7, 20));
  const Texture ridges =
      *TextureOf(*ComputedHeights(*ParseTextureSpec("grooves:height=1,pitch=3")));
  const auto sections = SectionsOf(ridges, std::array{0.5});
  const WorkArea area{TiledSection(sections[0], ridges.tile_mm, Placement{}), false, {}, nullptr};
  const double levels[] = {-4.5};  // x = 4.5: a ridge's middle, across the borders of tiles
  const auto sets = LevelLines(map, StraightField(map, {0, 1}), levels);
  ASSERT_TRUE(sets.ok());
  const auto runs = RunsOf(map, (*sets)[0].lines[0], area, 0);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_NEAR((map.Position(runs[0].back()) - map.Position(runs[0].front())).norm(), 20, 1e-9);
}

}  // namespace
}  // namespace slicefarm::texture::line_runs_test
