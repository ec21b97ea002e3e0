#include "services/infill/algo/quality/line_bead.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/model/bead_section.h"

namespace slicefarm::infill::line_bead_test {
namespace {

constexpr Coord kWidth = 450'000, kHeight = 200'000, kNozzle = 400'000;

// Half the density is twice the distance, with the same plastic in each line.
TEST(SparseBead, HasItsDistanceAndThePlasticOfALine) {
  const LineBead full = SparseBead(kWidth, kHeight, 0.9, 1);
  EXPECT_EQ(full.width_nm, kWidth);
  EXPECT_EQ(full.share, 0.9);
  const LineBead half = SparseBead(kWidth, kHeight, 0.9, 0.5);
  EXPECT_NEAR(static_cast<double>(Spacing(half.width_nm, kHeight)),
              2.0 * static_cast<double>(Spacing(kWidth, kHeight)), 1);
  EXPECT_NEAR(half.share, 0.45, 1e-12);
  const LineBead overlapping = SparseBead(kWidth, kHeight, 0.9, 1.2);
  EXPECT_NEAR(static_cast<double>(Spacing(overlapping.width_nm, kHeight)),
              static_cast<double>(Spacing(kWidth, kHeight)) / 1.2, 1);
  EXPECT_NEAR(overlapping.share, 1.08, 1e-12);
}

TEST(ThreadBead, IsARoundStrand) {
  for (const double density : {1.0, 0.6}) {
    const LineBead bead = ThreadBead(kNozzle, kHeight, 1, density);
    const auto spacing = static_cast<double>(Spacing(bead.width_nm, kHeight));
    EXPECT_NEAR(spacing, 450'000 / density, 1);
    // The plastic per length is the area of a disc with the nozzle's diameter.
    EXPECT_NEAR(bead.share * spacing * kHeight, std::numbers::pi / 4 * kNozzle * kNozzle, 1e6);
  }
}

TEST(ScaleSections, KeepsThePlasticInALayerOfAnotherHeight) {
  std::vector<Path> paths(1);
  paths[0].points = {{0, 0}, {1'000'000, 0}};
  paths[0].widths_nm = {kWidth};
  ScaleSections(1, 2 * kHeight, kHeight, paths);
  EXPECT_NEAR(SectionMm2(paths[0].widths_nm[0], kHeight), SectionMm2(kWidth, 2 * kHeight), 1e-6);
  ScaleSections(0.5, kHeight, kHeight, paths);
  EXPECT_NEAR(SectionMm2(paths[0].widths_nm[0], kHeight), SectionMm2(kWidth, 2 * kHeight) / 2,
              1e-6);
}

}  // namespace
}  // namespace slicefarm::infill::line_bead_test
