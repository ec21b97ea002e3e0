#include "services/texture/algo/paths/work_area.h"

#include <gtest/gtest.h>

#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::work_area_test {
namespace {

/// Ridges from 1 to 3 of each 4 mm, at half their height.
struct Sample {
  Texture ridges = *TextureOf(
      *ComputedHeights(*ParseTextureSpec("grooves:height=1,pitch=4,size=0.6,slope=0.1,detail=80")));
  std::vector<Section> sections = SectionsOf(ridges, std::array{0.5});
  TiledSection tiled = TiledSection(sections[0], ridges.tile_mm, Placement{});
};

TEST(WorkArea, IsTheSectionOrWhatIsNot) {
  const Sample s;
  WorkArea area{s.tiled, false, {}, nullptr};
  EXPECT_TRUE(area.Contains({2, 1}));
  EXPECT_FALSE(area.Contains({0.5, 1}));
  area.outside = true;
  EXPECT_FALSE(area.Contains({2, 1}));
  EXPECT_TRUE(area.Contains({0.5, 1}));
}

TEST(WorkArea, IsWithinMarginAndMasks) {
  const Sample s;
  const SurfaceMap map = MapFromAbove(FlatSquare(4, 20));
  const BoundaryMargin margin(map, 1.5);
  const TiledSection mask(s.sections[0], s.ridges.tile_mm,
                          Placement{.x_axis = {0, 1}});  // ridges along x
  const WorkArea area{s.tiled, false, {mask}, &margin};
  EXPECT_TRUE(area.Contains({2, 2}));
  EXPECT_FALSE(area.Contains({2, 1.2})) << "margin";
  EXPECT_FALSE(area.Contains({2, 4})) << "mask";
  EXPECT_TRUE(area.ContainsAll({2, 2}, {2.5, 2.5}));
  EXPECT_FALSE(area.ContainsAll({2, 2}, {6, 2})) << "across a groove";
  EXPECT_FALSE(area.ContainsAll({2, 2}, {2, 6})) << "across what is masked";
}

}  // namespace
}  // namespace slicefarm::texture::work_area_test
