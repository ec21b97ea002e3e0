#include "services/exposure/algo/scan/cell_lines.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::cell_lines_test {
namespace {

LineBlocks Blocks(const char* text, ScanStrategy strategy) {
  ExposureOptions options;
  options.strategy = strategy;
  options.stripe_width_nm = options.island_width_nm = 2'000'000;
  auto blocks = CellBlocks({MakePolygonsOrDie(text)}, 0, options);
  EXPECT_TRUE(blocks.ok());
  return *std::move(blocks);
}

TEST(CellBlocks, StripesEvenOnesFirst) {
  const LineBlocks blocks = Blocks("(0 0, 10 0, 10 10, 0 10)", ScanStrategy::kStripes);
  EXPECT_EQ(blocks.odd, (std::vector<bool>{false, false, false, true, true}));
  for (size_t b = 0; b < blocks.odd.size(); ++b) {
    const Box box = Bounds(
        std::span(blocks.points).subspan(blocks.begin[b], blocks.begin[b + 1] - blocks.begin[b]));
    const Coord stripe = b < 3 ? 2 * static_cast<Coord>(b) : 2 * static_cast<Coord>(b - 3) + 1;
    EXPECT_EQ(box.min.x, std::max<Coord>(0, stripe * 2'000'000 - 50'000));
    EXPECT_EQ(box.max.x, std::min<Coord>(10'000'000, (stripe + 1) * 2'000'000 + 50'000));
    EXPECT_EQ(box.min.y, b < 3 ? 0 : 40'000);  // shifted by half a distance
  }
}

TEST(CellBlocks, IslandsLieInSquares) {
  const LineBlocks blocks = Blocks("(0 0, 6 0, 6 6, 0 6)", ScanStrategy::kIslands);
  EXPECT_GE(blocks.odd.size(), 9u);
  for (size_t b = 0; b < blocks.odd.size(); ++b) {
    const Box box = Bounds(
        std::span(blocks.points).subspan(blocks.begin[b], blocks.begin[b + 1] - blocks.begin[b]));
    EXPECT_LE(box.max.x - box.min.x, 2'100'000);
    EXPECT_LE(box.max.y - box.min.y, 2'100'000);
  }
}

}  // namespace
}  // namespace slicefarm::exposure::cell_lines_test
