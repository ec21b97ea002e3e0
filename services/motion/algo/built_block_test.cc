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

/// Returns the layer with one block: a top line of 20 mm above a surface that falls from the
/// layer's top by 0.15 mm.
OrderedLayer FallingLine() {
  Path line = MakePathOrDie("(10 10, 30 10)");
  line.feature = Feature::kTopSolidInfill;
  OrderedLayer layer;
  layer.frame = {2, 600'000, 200'000};
  layer.blocks = {{0, 2, 200'000, {line}}};
  layer.visits = {{}};
  const Point a{FromMm(10), 0}, b{FromMm(30), 0}, c{FromMm(30), FromMm(20)},
      d{FromMm(10), FromMm(20)};
  layer.blocks[0].surface = {{{a, b, c}, {0, -150'000, -150'000}}, {{a, c, d}, {0, -150'000, 0}}};
  return layer;
}

TEST(BuildBlocks, ContouredPathsFollowTheSurfaceAndItsFlow) {
  MotionOptions options;
  const BuiltBlock level = BuildBlocks(FallingLine(), options, 2)[0];
  options.speeds[0].contour_least_nm = 50'000;
  const BuiltBlock contoured = BuildBlocks(FallingLine(), options, 2)[0];
  const auto printed = [](const BuiltBlock& block) {
    std::vector<Move> moves;
    for (const Move& move : block.path.moves)
      if (move.kind == MoveKind::kPrint) moves.push_back(move);
    return moves;
  };
  for (const Move& move : printed(level)) EXPECT_EQ(move.z_um, 600);
  ASSERT_FALSE(printed(contoured).empty());
  for (const Move& move : printed(contoured))
    EXPECT_NEAR(move.z_um, 600 - (move.x_um - 10'000) * 150 / 20'000, 3) << move.x_um;
  EXPECT_NEAR(contoured.stats.FilamentMm() / level.stats.FilamentMm(), 1 - 0.075 / 0.2, 0.01);
  // The nozzle is at the layer's top again before the next travel, and no wipe follows.
  EXPECT_EQ(contoured.path.moves.back().z_um, 600);
  for (const Move& move : contoured.path.moves) EXPECT_NE(move.kind, MoveKind::kWipe);
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
