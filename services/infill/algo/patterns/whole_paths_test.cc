#include "services/infill/algo/patterns/whole_paths.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::whole_paths_test {
namespace {

constexpr double kPitch = 2e6;

TEST(WholePaths, AreOneForEachIsland) {
  const MultiPolygon two = MakePolygonsOrDie(
      "(-24 -24, 24 -24, 24 24, -24 24) (-5 -5, -5 5, 5 5, 5 -5) ; (30 0, 60 0, 60 30, 30 30)");
  for (MakePattern* pattern : {Fermat, HilbertQuadtree, PeanoQuadtree}) {
    const auto pieces = pattern(two, {.pitch_nm = kPitch});
    ASSERT_TRUE(pieces.ok()) << pieces.status();
    EXPECT_EQ(pieces->size(), 2u);
    EXPECT_NEAR(LengthOf(*pieces) * kPitch / Area(two), 1, 0.06);
    for (const Piece& piece : *pieces) EXPECT_EQ(piece.from.ring, -1) << "no link takes hold";
  }
}

// The more lines there are, the less an odd number of lines matters.
TEST(WholePaths, ComeNearTheDensityWhereLinesAreMany) {
  for (MakePattern* pattern : {Fermat, HilbertQuadtree, PeanoQuadtree}) {
    for (const auto& [pitch, off] : {std::pair{4e6, 0.09}, {1e6, 0.03}, {0.5e6, 0.015}}) {
      const auto pieces = pattern(SampleBox(), {.pitch_nm = pitch});
      EXPECT_NEAR(LengthOf(*pieces) * pitch / Area(SampleBox()), 1, off) << pitch;
    }
  }
}

TEST(WholePaths, DoNotDependOnLayerAndAngle) {
  for (MakePattern* pattern : {Fermat, HilbertQuadtree, PeanoQuadtree}) {
    const auto first = pattern(SampleBox(), {.pitch_nm = kPitch});
    const auto other =
        pattern(SampleBox(), {.z_nm = 1'000'000, .layer = 5, .pitch_nm = kPitch, .angle_rad = 1});
    ASSERT_EQ(first->size(), other->size());
    for (size_t i = 0; i < first->size(); ++i) EXPECT_EQ((*first)[i].points, (*other)[i].points);
  }
}

}  // namespace
}  // namespace slicefarm::infill::whole_paths_test
