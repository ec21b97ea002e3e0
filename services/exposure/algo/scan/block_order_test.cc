#include "services/exposure/algo/scan/block_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace slicefarm::exposure::block_order_test {
namespace {

std::vector<ScanBlock> RandomBlocks(size_t count, std::mt19937_64& random, bool reversible) {
  const auto place = [&] {
    return Point{static_cast<Coord>(random() % 100'000'000),
                 static_cast<Coord>(random() % 100'000'000)};
  };
  std::vector<ScanBlock> blocks(count);
  for (size_t i = 0; i < count; ++i)
    blocks[i] = {.start = place(), .end = place(), .reversible = reversible, .odd = i % 2 == 1};
  return blocks;
}

/// Returns the nearest-first order by testing all remaining blocks.
std::vector<BlockTurn> BruteNearest(const std::vector<ScanBlock>& blocks, Point from) {
  std::vector<BlockTurn> turns;
  std::set<size_t> left;
  for (size_t i = 0; i < blocks.size(); ++i) left.insert(i);
  while (!left.empty()) {
    BlockTurn best;
    double least = INFINITY;
    for (const size_t i : left) {
      for (const bool reversed : {false, true}) {
        if (reversed && !blocks[i].reversible) continue;
        const double distance = Distance(from, reversed ? blocks[i].end : blocks[i].start);
        if (distance < least) least = distance, best = {i, reversed};
      }
    }
    turns.push_back(best);
    left.erase(best.block);
    from = best.reversed ? blocks[best.block].start : blocks[best.block].end;
  }
  return turns;
}

TEST(OrderBlocks, NearestIsWhatTryingAllFinds) {
  std::mt19937_64 random(1);
  for (const size_t count : {0u, 1u, 2u, 7u, 100u, 400u})
    for (const bool reversible : {false, true}) {
      const auto blocks = RandomBlocks(count, random, reversible);
      const Point from{50'000'000, -20'000'000};
      EXPECT_EQ(OrderBlocks(blocks, JumpOrder::kNearest, from), BruteNearest(blocks, from));
    }
}

TEST(OrderBlocks, OnALineOfPlaces) {
  std::vector<ScanBlock> blocks;
  for (Coord i = 0; i < 50; ++i) blocks.push_back({.start = {i * 1000, 0}, .end = {i * 1000, 0}});
  const auto turns = OrderBlocks(blocks, JumpOrder::kNearest, {});
  for (size_t i = 0; i < turns.size(); ++i) EXPECT_EQ(turns[i].block, i);
}

TEST(OrderBlocks, ChequerboardDoesOneColourFirst) {
  std::mt19937_64 random(2);
  const auto blocks = RandomBlocks(101, random, false);
  const auto turns = OrderBlocks(blocks, JumpOrder::kChequerboard, {});
  ASSERT_EQ(turns.size(), blocks.size());
  for (size_t i = 0; i < turns.size(); ++i) EXPECT_EQ(blocks[turns[i].block].odd, i >= 51);
}

TEST(OrderBlocks, EachBlockOnce) {
  std::mt19937_64 random(3);
  const auto blocks = RandomBlocks(333, random, true);
  for (const JumpOrder order : {JumpOrder::kNearest, JumpOrder::kChequerboard, JumpOrder::kFarthest,
                                JumpOrder::kAgainstGas}) {
    std::set<size_t> seen;
    for (const BlockTurn& turn : OrderBlocks(blocks, order, {})) seen.insert(turn.block);
    EXPECT_EQ(seen.size(), blocks.size());
  }
}

/// 50 flow directions are tested. Each block's middle is at least as far along the flow as the next
/// one's, and a reversible block ends on the side from which the gas flows.
TEST(OrderBlocks, AgainstGasGoesUpTheFlow) {
  std::mt19937_64 random(5);
  for (const bool reversible : {false, true}) {
    std::vector<ScanBlock> blocks = RandomBlocks(80, random, reversible);
    for (ScanBlock& block : blocks) block.middle = block.start;
    for (double gas = -360; gas < 360; gas += 15) {
      const auto along = [&](Point p) {
        return std::cos(gas * M_PI / 180) * static_cast<double>(p.x) +
               std::sin(gas * M_PI / 180) * static_cast<double>(p.y);
      };
      const auto turns = OrderBlocks(blocks, JumpOrder::kAgainstGas, {}, gas);
      ASSERT_EQ(turns.size(), blocks.size());
      for (size_t i = 0; i < turns.size(); ++i) {
        const ScanBlock& block = blocks[turns[i].block];
        const bool ends_down = along(block.end) > along(block.start) + 1;
        EXPECT_EQ(turns[i].reversed, reversible && ends_down);
        const ScanBlock& before = blocks[turns[i == 0 ? 0 : i - 1].block];
        EXPECT_GE(along(before.middle), along(block.middle) - 1);
      }
    }
  }
}

TEST(OrderBlocks, FarthestJumpsFartherThanNearest) {
  std::mt19937_64 random(4);
  const auto blocks = RandomBlocks(60, random, false);
  const auto path = [&](JumpOrder order) {
    double sum = 0;
    Point at;
    for (const BlockTurn& turn : OrderBlocks(blocks, order, {})) {
      sum += Distance(at, blocks[turn.block].start);
      at = blocks[turn.block].end;
    }
    return sum;
  };
  EXPECT_GT(path(JumpOrder::kFarthest), path(JumpOrder::kChequerboard));
  EXPECT_GT(path(JumpOrder::kChequerboard), path(JumpOrder::kNearest));
}

}  // namespace
}  // namespace slicefarm::exposure::block_order_test
