#include "common/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace slicefarm::disjoint_sets_test {
namespace {

TEST(DisjointSets, JoinOnce) {
  DisjointSets sets(4);
  EXPECT_EQ(sets.sets(), 4);
  EXPECT_TRUE(sets.Join(0, 3));
  EXPECT_TRUE(sets.Join(1, 2));
  EXPECT_FALSE(sets.AreJoined(0, 1));
  EXPECT_TRUE(sets.Join(3, 2));
  EXPECT_FALSE(sets.Join(0, 1));
  EXPECT_FALSE(sets.Join(2, 2));
  EXPECT_EQ(sets.sets(), 1);
}

// The sets equal the sets of a simple implementation that repaints colours.
TEST(DisjointSets, AreThoseOfTheJoins) {
  constexpr int32_t kCount = 60;
  std::mt19937 random(3);
  DisjointSets sets(kCount);
  std::vector<int32_t> colours(kCount);
  std::iota(colours.begin(), colours.end(), 0);
  for (int i = 0; i < 80; ++i) {
    const auto a = static_cast<int32_t>(random() % kCount),
               b = static_cast<int32_t>(random() % kCount);
    const int32_t from = colours[static_cast<size_t>(a)], to = colours[static_cast<size_t>(b)];
    EXPECT_EQ(sets.AreJoined(a, b), from == to);
    EXPECT_EQ(sets.Join(a, b), from != to);
    std::ranges::replace(colours, from, to);
  }
}

}  // namespace
}  // namespace slicefarm::disjoint_sets_test
