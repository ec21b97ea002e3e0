#include "common/model/bead_section.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/base/error.h"

namespace slicefarm::bead_section_test {
namespace {

TEST(BeadSection, OfTheUsualBead) {
  // A bead 0.45 mm wide and 0.2 mm high: PrusaSlicer writes 0.407080 spacing and 0.0814159 mm3/mm.
  EXPECT_EQ(Spacing(450'000, 200'000), 407'080);
  EXPECT_NEAR(SectionMm2(450'000, 200'000), 0.0814159, 1e-7);
  EXPECT_EQ(WidthForSpacing(407'080, 200'000), 450'000);
}

TEST(BeadSection, AsWideAsHighIsADisc) {
  EXPECT_NEAR(SectionMm2(200'000, 200'000), std::numbers::pi * 0.01, 1e-9);
  EXPECT_NEAR(SectionMm2(100'000, 200'000), std::numbers::pi * 0.0025, 1e-9);
}

TEST(BeadSection, NeighboursTile) {
  for (Coord width = 200'000; width <= 1'200'000; width += 50'000)
    EXPECT_NEAR(SectionMm2(width, 200'000),
                0.2 * ToMm(static_cast<double>(Spacing(width, 200'000))), 1e-6);
}

TEST(BeadSection, FillsAStripOfAnyWidth) {
  for (Coord strip = 10'000; strip <= 800'000; strip += 10'000)
    EXPECT_NEAR(SectionMm2(WidthToFill(strip, 200'000), 200'000),
                0.2 * ToMm(static_cast<double>(strip)), 1e-6);
}

TEST(BeadSection, BeadsThatDoNotLieApartAreRefused) {
  EXPECT_TRUE(CheckSpacing("extrusion_width", 42'921, 200'000).ok());
  EXPECT_EQ(DetailOf(CheckSpacing("extrusion_width", 42'920, 200'000)).reason,
            Reason::kSettingOutOfRange);
  const ErrorDetail detail = DetailOf(CheckSpacing("extrusion_width", -450'000, 200'000));
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(detail.metadata.at("setting"), "extrusion_width");
  EXPECT_EQ(detail.metadata.at("value"), "-0.45");
}

}  // namespace
}  // namespace slicefarm::bead_section_test
