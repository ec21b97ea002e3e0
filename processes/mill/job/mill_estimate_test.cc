#include "processes/mill/job/mill_estimate.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::coordinator::mill_estimate_test {
namespace {

/// A block of 10 x 10 mm with a given number of layers, each 1 mm high.
struct Block {
  explicit Block(int count) {
    Polygon square = {{0, 0}, {FromMm(10), 0}, {FromMm(10), FromMm(10)}, {0, FromMm(10)}};
    for (int i = 0; i < count; ++i) {
      SlicedLayer& layer = layers.emplace_back();
      layer.frame = {i, FromMm(i + 1), FromMm(1)};
      ObjectSection& section = layer.sections.emplace_back();
      section.regions.push_back({.outlines = {{square, {}}}});
    }
    copies.push_back({0, {}, square});
  }
  SlicedOutlines outlines() const { return {layers, copies}; }

  std::vector<SlicedLayer> layers;
  std::vector<PlacedCopy> copies;
};

TEST(EstimateMilling, AddsWhatIsCut) {
  MillingOptions how;  // a stepover of 1.6 mm, a stepdown of 1 mm, 800 mm/min
  how.finishing = false;
  const Block block(5);
  // The removed volume is a box of 12 x 12 x 6 mm less 500 mm3.
  const JobEstimate rough = EstimateMilling(block.outlines(), how);
  EXPECT_NEAR(rough.print_time_s, 60 * (144.0 * 6 - 500) / 1.6 / 800, 1e-9);
  EXPECT_EQ(rough.layers, 6);
  how.finishing = true;
  const JobEstimate all = EstimateMilling(block.outlines(), how);
  EXPECT_NEAR(all.print_time_s - rough.print_time_s, 60 * (40.0 * 5 + 100) / 0.25 / 800, 1e-9);
  EXPECT_EQ(all.layers, 26);
}

TEST(EstimateMilling, TakesLessForWhatIsCoarser) {
  const Block block(9);
  const MillingOptions usual;
  MillingOptions coarse = usual, fast = usual;
  coarse.stepdown_mm = 2;
  fast.machining.feed_mm_min = 1600;
  const double time = EstimateMilling(block.outlines(), usual).print_time_s;
  EXPECT_LT(EstimateMilling(block.outlines(), coarse).print_time_s, time);
  EXPECT_DOUBLE_EQ(EstimateMilling(block.outlines(), fast).print_time_s, time / 2);
}

}  // namespace
}  // namespace slicefarm::coordinator::mill_estimate_test
