#include "services/coordinator/algo/pipeline/print_estimate.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format.h"

namespace slicefarm::coordinator {
namespace {

constexpr int kSkins = 5;

std::vector<SlicedLayer> Layers(const std::vector<std::string>& outlines) {
  std::vector<SlicedLayer> layers;
  for (const std::string& outline : outlines) {
    SlicedLayer layer;
    layer.frame.index = static_cast<int32_t>(layers.size());
    layer.frame.height_nm = FromMm(0.2);
    layer.frame.print_z_nm = FromMm(0.2 * (layer.frame.index + 1));
    if (!outline.empty()) layer.objects = {{0, MakePolygonsOrDie(outline)}};
    layers.push_back(layer);
  }
  return layers;
}

std::vector<SlicedLayer> Cube(int layers) {
  return Layers(std::vector<std::string>(layers, "(0 0, 20 0, 20 20, 0 20)"));
}

TEST(EstimatePrint, ASolidCubeTakesItsVolume) {
  JobSettings settings;
  settings.infill.density = 1;
  EXPECT_NEAR(EstimatePrint(Cube(100), settings).filament.volume_mm3, 20 * 20 * 20, 1e-6);
}

TEST(EstimatePrint, SkinsAndWallsAreSolidAndTheRestIsAsDenseAsAskedFor) {
  JobSettings settings;
  const double wall = 0.45 - 0.2 * (1 - 3.14159265358979 / 4);
  const double wall_area = 3 * wall * 80;
  const double all = 20 * 20 * 20;
  const double sparse = (400 - wall_area) * 0.2 * (100 - 2 * kSkins) * (1 - 0.2);
  EXPECT_NEAR(EstimatePrint(Cube(100), settings).filament.volume_mm3, all - sparse, 1e-6);
}

TEST(EstimatePrint, AStepIsCoveredBySkins) {
  std::vector<std::string> stair(60, "(0 0, 20 0, 20 20, 0 20)");
  std::fill(stair.begin() + 30, stair.end(), "(0 0, 10 0, 10 20, 0 20)");
  JobSettings settings;
  settings.beading.perimeters = 0;
  settings.infill.density = 0;
  const double skins = 0.2 * kSkins * (400 + 200 + 200);
  EXPECT_NEAR(EstimatePrint(Layers(stair), settings).filament.volume_mm3, skins, 1e-6);
}

TEST(EstimatePrint, WallsAreNeverMoreThanThereIsRoomFor) {
  JobSettings settings;
  settings.beading.perimeters = 1000;
  EXPECT_NEAR(EstimatePrint(Cube(100), settings).filament.volume_mm3, 8000, 1e-6);
}

TEST(EstimatePrint, TimeGrowsWithWhatIsPrintedAndFallsWithSpeed) {
  const JobSettings usual;
  JobSettings denser = usual;
  denser.infill.density = 0.8;
  JobSettings faster = usual;
  faster.motion.speed_mm_s.fill(200);
  const double time = EstimatePrint(Cube(100), usual).print_time_s;
  EXPECT_GT(EstimatePrint(Cube(100), denser).print_time_s, 1.2 * time);
  EXPECT_LT(EstimatePrint(Cube(100), faster).print_time_s, 0.8 * time);
  EXPECT_GT(EstimatePrint(Cube(200), usual).print_time_s, 1.5 * time);
}

TEST(EstimatePrint, SmallLayersTakeAsLongAsCoolingWants) {
  JobSettings settings;
  settings.motion.cooling.slowdown_below_layer_time_s = 30;
  const auto needle = Layers(std::vector<std::string>(10, "(0 0, 1 0, 1 1, 0 1)"));
  EXPECT_DOUBLE_EQ(EstimatePrint(needle, settings).print_time_s, 300);
}

TEST(EstimatePrint, NothingTakesNothing) {
  EXPECT_EQ(EstimatePrint({}, {}).print_time_s, 0);
  EXPECT_EQ(EstimatePrint(Layers({"", ""}), {}).print_time_s, 0);
}

}  // namespace
}  // namespace slicefarm::coordinator
