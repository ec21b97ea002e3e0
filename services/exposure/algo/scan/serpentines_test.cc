#include "services/exposure/algo/scan/serpentines.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::serpentines_test {
namespace {

LineBlocks Blocks(const char* text) {
  auto blocks = SerpentineBlocks({MakePolygonsOrDie(text)}, 0, {});
  EXPECT_TRUE(blocks.ok());
  return *std::move(blocks);
}

TEST(SerpentineBlocks, AConvexRegionIsOne) {
  const LineBlocks blocks = Blocks("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_EQ(blocks.odd.size(), 1u);
  EXPECT_EQ(blocks.begin, (std::vector<size_t>{0, 250}));
}

TEST(SerpentineBlocks, AHolePartsThem) {
  // One block is below, to the left and above the hole; the other is to its right.
  const LineBlocks blocks = Blocks("(0 0, 10 0, 10 10, 0 10) (4 4, 6 4, 6 6, 4 6)");
  EXPECT_EQ(blocks.odd.size(), 2u);
  EXPECT_EQ(blocks.begin.size(), 3u);
  EXPECT_EQ(blocks.points.size(), 2 * (125u + 25u));
}

TEST(SerpentineBlocks, NothingHasNone) { EXPECT_TRUE(SerpentineBlocks({}, 0, {})->begin.empty()); }

}  // namespace
}  // namespace slicefarm::exposure::serpentines_test
