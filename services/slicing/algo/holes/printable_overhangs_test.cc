#include "services/slicing/algo/holes/printable_overhangs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::printable_overhangs_test {
namespace {

ObjectSection SectionAt(int32_t layer, std::string_view outlines, int32_t settings = 0) {
  ObjectSection section;
  section.layer = layer;
  section.height_nm = 1'000'000;
  if (outlines.empty()) return section;
  Region region;
  region.settings = settings;
  region.outlines = MakePolygonsOrDie(outlines);
  section.regions.push_back(std::move(region));
  return section;
}

std::vector<ObjectSection> Printable(std::vector<ObjectSection> sections, double degrees,
                                     double hole_mm2 = 0) {
  std::vector<ObjectSection*> all;
  for (ObjectSection& section : sections) all.push_back(&section);
  MakeOverhangsPrintable({true, degrees * std::numbers::pi / 180, hole_mm2}, all);
  return sections;
}

double AreaAt(const ObjectSection& section) { return Area(OutlineOf(section)) / 1e12; }

// A plate of 20 mm on a post of 4 mm. At 45 degrees, each layer of 1 mm below the plate is 1 mm
// smaller on each side.
std::vector<ObjectSection> Mushroom() {
  std::vector<ObjectSection> sections;
  for (int32_t i = 0; i < 12; ++i) sections.push_back(SectionAt(i, "(-2 -2, 2 -2, 2 2, -2 2)"));
  sections.push_back(SectionAt(12, "(-10 -10, 10 -10, 10 10, -10 10)"));
  return sections;
}

TEST(MakeOverhangsPrintable, MakesCones) {
  const auto made = Printable(Mushroom(), 45);
  for (int below = 0; below <= 12; ++below) {
    const double side = std::max(4.0, 20.0 - 2 * below);
    EXPECT_NEAR(AreaAt(made[static_cast<size_t>(12 - below)]), side * side, 1e-3) << below;
  }
}

TEST(MakeOverhangsPrintable, ASmallerAngleMakesSteeperCones) {
  const auto made = Printable(Mushroom(), 30);
  EXPECT_NEAR(AreaAt(made[11]), std::pow(20 - 2 * std::tan(std::numbers::pi / 6), 2), 1e-2);
  const auto same = Printable(Mushroom(), 90);
  for (size_t i = 0; i < same.size(); ++i) EXPECT_EQ(same[i], Mushroom()[i]) << i;
}

TEST(MakeOverhangsPrintable, KeepsSmallHolesOpen) {
  const auto sections = [] {
    return std::vector<ObjectSection>{
        SectionAt(0, "(-9 -9, 9 -9, 9 9, -9 9) (-4 -4, -4 4, 4 4, 4 -4)"),
        SectionAt(1, "(-9 -9, 9 -9, 9 9, -9 9)")};
  };
  EXPECT_NEAR(AreaAt(Printable(sections(), 45)[0]), 324, 1e-3);
  EXPECT_NEAR(AreaAt(Printable(sections(), 45, 60)[0]), 324, 1e-3);
  EXPECT_NEAR(AreaAt(Printable(sections(), 45, 70)[0]), 324 - 64, 1e-3);
}

TEST(MakeOverhangsPrintable, MaterialBelongsToTheRegionAbove) {
  const auto made = Printable(
      {SectionAt(0, "(-2 -2, 2 -2, 2 2, -2 2)", 3), SectionAt(1, "(-9 -9, 9 -9, 9 9, -9 9)", 5)},
      45);
  ASSERT_EQ(made[0].regions.size(), 2u);
  EXPECT_EQ(made[0].regions[0].settings, 3);
  EXPECT_EQ(made[0].regions[1].settings, 5);
  EXPECT_NEAR(AreaAt(made[0]), 256, 1e-3);
}

TEST(MakeOverhangsPrintable, FillsEmptyLayers) {
  const auto made = Printable({SectionAt(0, ""), SectionAt(1, "(0 0, 9 0, 9 9, 0 9)")}, 45);
  EXPECT_NEAR(AreaAt(made[0]), 49, 1e-3);
}

}  // namespace
}  // namespace slicefarm::slicing::printable_overhangs_test
