#include "services/infill/algo/quality/fill_plastic.h"

#include <gtest/gtest.h>

#include "common/model/bead_section.h"

namespace slicefarm::infill::fill_plastic_test {
namespace {

constexpr Coord kHeight = 200'000;

Path LineOf(std::vector<Point> mm, std::vector<Coord> widths_um, bool closed = false) {
  Path path;
  path.closed = closed;
  for (const Point p : mm) path.points.push_back({p.x * kNmPerMm, p.y * kNmPerMm});
  for (const Coord um : widths_um) path.widths_nm.push_back(um * 1000);
  return path;
}

TEST(PlasticMm3, OfOneWidthIsLengthTimesSection) {
  EXPECT_NEAR(PlasticMm3(LineOf({{0, 0}, {3, 4}, {3, 9}}, {450}), kHeight),
              10 * SectionMm2(450'000, kHeight), 1e-12);
  EXPECT_NEAR(PlasticMm3(LineOf({{0, 0}, {3, 0}, {3, 4}}, {450}, true), kHeight),
              12 * SectionMm2(450'000, kHeight), 1e-12);
}

// Between two widths, the plastic is that of the mean width, because the section grows evenly.
TEST(PlasticMm3, OfSeveralWidthsGoesEdgeByEdge) {
  EXPECT_NEAR(PlasticMm3(LineOf({{0, 0}, {2, 0}, {2, 0}, {5, 0}}, {400, 600, 300, 300}), kHeight),
              2 * SectionMm2(500'000, kHeight) + 3 * SectionMm2(300'000, kHeight), 1e-12);
  EXPECT_NEAR(PlasticMm3(LineOf({{0, 0}, {3, 0}, {3, 4}}, {400, 400, 500}, true), kHeight),
              3 * SectionMm2(400'000, kHeight) + (4 + 5) * SectionMm2(450'000, kHeight), 1e-12);
}

TEST(UseOf, SumsPathsAndKeepsTheLongest) {
  const std::vector<Path> paths = {LineOf({{0, 0}, {10, 0}}, {450}),
                                   LineOf({{0, 1}, {30, 1}}, {450})};
  const FillStats use = UseOf({.feature = Feature::kBridgeInfill,
                               .pattern = FillPattern::kGrid,
                               .area_nm2 = 50e12,
                               .height_nm = 2 * kHeight,
                               .share = 0.25},
                              paths, kHeight);
  EXPECT_EQ(use.settings, 0);
  EXPECT_EQ(use.feature, Feature::kBridgeInfill);
  EXPECT_EQ(use.pattern, FillPattern::kGrid);
  EXPECT_NEAR(use.area_mm2, 50, 1e-9);
  EXPECT_NEAR(use.volume_mm3, 20, 1e-9);
  EXPECT_NEAR(use.asked_mm3, 5, 1e-9);
  EXPECT_NEAR(use.plastic_mm3, 40 * SectionMm2(450'000, kHeight), 1e-9);
  EXPECT_EQ(use.paths, 2);
  EXPECT_NEAR(use.length_mm, 40, 1e-9);
  EXPECT_NEAR(use.longest_mm, 30, 1e-9);
}

// An area that is too narrow for any path still counts as requested.
TEST(UseOf, NoPathsAreAUseToo) {
  const FillStats use = UseOf({.pattern = {}, .area_nm2 = 1e12, .height_nm = kHeight}, {}, kHeight);
  EXPECT_EQ(use.paths, 0);
  EXPECT_NEAR(use.asked_mm3, 0.2, 1e-12);
  EXPECT_EQ(use.plastic_mm3, 0);
}

}  // namespace
}  // namespace slicefarm::infill::fill_plastic_test
