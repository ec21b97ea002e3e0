#include "processes/fdm/job/print_estimate.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::coordinator::print_estimate_test {
namespace {

constexpr int kSkins = 5;

struct Plate {
  std::vector<SlicedLayer> layers;
  std::vector<PlacedCopy> copies;
};

/// Returns a section of an object with layers of 0.2 mm.
ObjectSection SectionOf(int32_t object, const std::string& outlines) {
  ObjectSection section;
  section.stack = object;
  section.height_nm = FromMm(0.2);
  if (!outlines.empty()) section.regions = {{.outlines = MakePolygonsOrDie(outlines)}};
  return section;
}

/// Returns a plate with one copy of one object.
Plate Layers(const std::vector<std::string>& outlines) {
  Plate plate;
  for (const std::string& outline : outlines) {
    SlicedLayer layer;
    layer.frame.index = static_cast<int32_t>(plate.layers.size());
    layer.frame.height_nm = FromMm(0.2);
    layer.frame.print_z_nm = FromMm(0.2 * (layer.frame.index + 1));
    layer.sections = {SectionOf(0, outline)};
    layer.sections[0].layer = layer.frame.index;
    layer.sections[0].layer_count = static_cast<int32_t>(outlines.size());
    plate.layers.push_back(layer);
  }
  plate.copies.resize(1);
  return plate;
}

Plate Cube(int layers) {
  return Layers(std::vector<std::string>(layers, "(0 0, 20 0, 20 20, 0 20)"));
}

/// Adds one copy of a second object, which has another row of settings.
void AddCube(Plate& plate, int layers) {
  for (int i = 0; i < layers; ++i) {
    ObjectSection section = SectionOf(1, "(0 0, 20 0, 20 20, 0 20)");
    section.layer = i;
    section.layer_count = layers;
    section.regions[0].settings = 1;
    plate.layers[i].sections.push_back(section);
  }
  plate.copies.emplace_back().object = 1;
}

/// Returns settings with a second row equal to the first.
FdmSettings TwoRows() {
  FdmSettings settings;
  settings.regions.resize(2);
  return settings;
}

JobEstimate Estimate(const Plate& plate, const FdmSettings& settings) {
  return EstimatePrint({plate.layers, plate.copies}, settings);
}

TEST(EstimatePrint, ASolidCubeTakesItsVolume) {
  FdmSettings settings;
  settings.regions[0].infill.density = 1;
  EXPECT_NEAR(Estimate(Cube(100), settings).filament.volume_mm3, 20 * 20 * 20, 1e-6);
}

TEST(EstimatePrint, SkinsAndWallsAreSolidAndTheRestIsAsDenseAsAskedFor) {
  FdmSettings settings;
  const double wall = 0.45 - 0.2 * (1 - 3.14159265358979 / 4);
  const double wall_area = 3 * wall * 80;
  const double all = 20 * 20 * 20;
  const double sparse = (400 - wall_area) * 0.2 * (100 - 2 * kSkins) * (1 - 0.2);
  EXPECT_NEAR(Estimate(Cube(100), settings).filament.volume_mm3, all - sparse, 1e-6);
}

TEST(EstimatePrint, AStepIsCoveredBySkins) {
  std::vector<std::string> stair(60, "(0 0, 20 0, 20 20, 0 20)");
  std::fill(stair.begin() + 30, stair.end(), "(0 0, 10 0, 10 20, 0 20)");
  FdmSettings settings;
  settings.regions[0].walls.perimeters = 0;
  settings.regions[0].infill.density = 0;
  const double skins = 0.2 * kSkins * (400 + 200 + 200);
  EXPECT_NEAR(Estimate(Layers(stair), settings).filament.volume_mm3, skins, 1e-6);
}

TEST(EstimatePrint, WallsAreNeverMoreThanThereIsRoomFor) {
  FdmSettings settings;
  settings.regions[0].walls.perimeters = 1000;
  EXPECT_NEAR(Estimate(Cube(100), settings).filament.volume_mm3, 8000, 1e-6);
}

TEST(EstimatePrint, TimeGrowsWithWhatIsPrintedAndFallsWithSpeed) {
  const FdmSettings usual;
  FdmSettings denser = usual;
  denser.regions[0].infill.density = 0.8;
  FdmSettings faster = usual;
  faster.regions[0].motion.speed_mm_s.fill(200);
  const double time = Estimate(Cube(100), usual).print_time_s;
  EXPECT_GT(Estimate(Cube(100), denser).print_time_s, 1.2 * time);
  EXPECT_LT(Estimate(Cube(100), faster).print_time_s, 0.8 * time);
  EXPECT_GT(Estimate(Cube(200), usual).print_time_s, 1.5 * time);
}

TEST(EstimatePrint, SmallLayersTakeAsLongAsCoolingWants) {
  FdmSettings settings;
  settings.tools[0].cooling.slowdown_below_layer_time_s = 30;
  const auto needle = Layers(std::vector<std::string>(10, "(0 0, 1 0, 1 1, 0 1)"));
  EXPECT_DOUBLE_EQ(Estimate(needle, settings).print_time_s, 300);
}

TEST(EstimatePrint, EachCopyTakesAsMuch) {
  Plate plate = Cube(100);
  const JobEstimate one = Estimate(plate, {});
  plate.copies.resize(3);
  const JobEstimate three = Estimate(plate, {});
  EXPECT_NEAR(three.filament.volume_mm3, 3 * one.filament.volume_mm3, 1e-6);
  EXPECT_NEAR(three.print_time_s, 3 * one.print_time_s, 1e-6);
}

// The copies are printed alternately, and each copy cools while the rest of them are printed.
TEST(EstimatePrint, CoolingWantsItsTimeOfTheLayerAndNotOfEachCopy) {
  FdmSettings settings;
  settings.tools[0].cooling.slowdown_below_layer_time_s = 30;
  Plate needles = Layers(std::vector<std::string>(10, "(0 0, 1 0, 1 1, 0 1)"));
  needles.copies.resize(5);
  EXPECT_DOUBLE_EQ(Estimate(needles, settings).print_time_s, 300);
}

TEST(EstimatePrint, ObjectsOfAPlateAddUp) {
  Plate plate = Cube(100);
  const double one = Estimate(plate, {}).filament.volume_mm3;
  AddCube(plate, 100);
  EXPECT_NEAR(Estimate(plate, TwoRows()).filament.volume_mm3, 2 * one, 1e-6);
}

TEST(EstimatePrint, AnObjectIsAsDenseAsItsOwnSettingsSay) {
  FdmSettings settings = TwoRows();
  settings.regions[1].infill.density = 1;
  Plate plate = Cube(100);
  const double sparse = Estimate(plate, settings).filament.volume_mm3;
  AddCube(plate, 100);
  EXPECT_NEAR(Estimate(plate, settings).filament.volume_mm3, sparse + 8000, 1e-6);
}

// A lower object ends in its own skin, even if a taller object is beside it.
TEST(EstimatePrint, SkinsAreThoseOfTheObject) {
  FdmSettings settings = TwoRows();
  for (RegionRow& region : settings.regions) {
    region.walls.perimeters = 0;
    region.infill.density = 0;
  }
  Plate plate = Cube(100);
  AddCube(plate, 50);
  const double skins = 2 * 2 * kSkins * 0.2 * 400;
  EXPECT_NEAR(Estimate(plate, settings).filament.volume_mm3, skins, 1e-6);
}

TEST(EstimatePrint, NothingTakesNothing) {
  EXPECT_EQ(EstimatePrint({}, {}).print_time_s, 0);
  EXPECT_EQ(Estimate(Layers({"", ""}), {}).print_time_s, 0);
}

}  // namespace
}  // namespace slicefarm::coordinator::print_estimate_test
