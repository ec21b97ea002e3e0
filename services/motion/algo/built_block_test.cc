#include "services/motion/algo/built_block.h"

#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::motion::built_block_test {
namespace {

PathBlock Square() {
  Path square = MakePathOrDie("(10 10, 30 10, 30 30, 10 30)", true);
  square.feature = Feature::kExternalPerimeter;
  return {0, 2, 200'000, {square}};
}

OrderedLayer TwoBlocks() {
  OrderedLayer layer;
  layer.frame = {2, 600'000, 200'000};
  layer.blocks = {Square(), Square()};
  layer.visits = {{0, 0, 0, {}}, {1, 1, 0, {FromMm(50), 0}}};
  return layer;
}

TEST(BuildBlocks, EachBlockHasItsMovesInItsOwnCoordinates) {
  const std::vector<BuiltBlock> built = BuildBlocks(TwoBlocks(), MotionOptions(), 2);
  ASSERT_EQ(built.size(), 2u);
  for (const BuiltBlock& block : built) {
    ASSERT_FALSE(block.path.moves.empty());
    EXPECT_GT(block.stats.FilamentMm(), 0);
    EXPECT_TRUE(block.ends_retracted);
    EXPECT_LE(block.Exit().x, FromMm(30)) << "the shift of a copy belongs to its visit";
  }
}

TEST(BuildBlocks, OnlyABlockThatEndsReadyKeepsTheFilament) {
  OrderedLayer layer = TwoBlocks();
  layer.ends_ready = true;
  const std::vector<BuiltBlock> built = BuildBlocks(layer, MotionOptions(), 2);
  ASSERT_EQ(built.size(), 2u);
  EXPECT_TRUE(built[0].ends_retracted);
  EXPECT_FALSE(built[1].ends_retracted);
}

TEST(HandOver, RetractsWhatTheLayerBelowLeftReady) {
  OrderedLayer layer;
  layer.frame = {2, 600'000, 200'000};
  EXPECT_TRUE(HandOver(layer, MotionOptions()).path.moves.empty());
  layer.begins_ready = true;
  const BuiltBlock block = HandOver(layer, MotionOptions());
  EXPECT_FALSE(block.path.moves.empty());
  EXPECT_TRUE(block.ends_retracted);
}

}  // namespace
}  // namespace slicefarm::motion::built_block_test
