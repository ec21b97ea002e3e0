#include "services/slicing/algo/mesh_io/weld.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <set>

#include "common/model/scene/mesh.h"

namespace slicefarm::slicing::weld_test {
namespace {

TEST(Welder, NumbersDistinctPointsInOrder) {
  Welder<Vertex> welder(0);
  EXPECT_EQ(welder.Add({1, 2, 3}), 0u);
  EXPECT_EQ(welder.Add({3, 2, 1}), 1u);
  EXPECT_EQ(welder.Add({1, 2, 3}), 0u);
  EXPECT_EQ(welder.Add({1, 2, 4}), 2u);
  EXPECT_EQ(std::move(welder).TakePoints(), (std::vector<Vertex>{{1, 2, 3}, {3, 2, 1}, {1, 2, 4}}));
}

TEST(Welder, GrowsAsNeeded) {
  Welder<Vertex> welder(4);
  for (int pass = 0; pass < 2; ++pass)
    for (Coord i = 0; i < 50'000; ++i)
      ASSERT_EQ(welder.Add({i % 100, (i / 100) << 32, -i}), static_cast<uint32_t>(i));
  EXPECT_EQ(std::move(welder).TakePoints().size(), 50'000u);
}

/// Returns a vertex with a z chosen so that all of these vertices would share a slot under the
/// previous hash. That hash had no keys: it applied rotate, xor and multiply with known numbers.
Vertex Crafted(uint64_t x, uint64_t y) {
  uint64_t hash = x * 0x9E3779B97F4A7C15u;
  hash = (std::rotl(hash, 29) ^ y) * 0xBF58476D1CE4E5B9u;
  return {static_cast<Coord>(x), static_cast<Coord>(y), static_cast<Coord>(std::rotl(hash, 29))};
}

TEST(PointHash, SpreadsPointsMadeToCollide) {
  constexpr size_t kPoints = 65'536;
  std::set<uint64_t> slots;
  for (uint64_t i = 0; i < kPoints; ++i) {
    const Vertex point = Crafted(i, i / 3);
    slots.insert(PointHash::OfProcess()(std::bit_cast<std::array<uint64_t, 3>>(point)) % (1 << 20));
  }
  EXPECT_GT(slots.size(), kPoints * 9 / 10);  // 97 % are to be expected
}

TEST(PointHash, FollowsItsKeys) {
  const PointHash a({1, 2, 3, 4}), same({1, 2, 3, 4}), b({5, 6, 7, 8});
  EXPECT_EQ(a({9, 9, 9}), same({9, 9, 9}));
  EXPECT_NE(a({9, 9, 9}), b({9, 9, 9}));
  EXPECT_EQ(PointHash::OfProcess()({9, 9, 9}), PointHash::OfProcess()({9, 9, 9}));
}

TEST(PointHash, SpreadsCoordinatesOfAGrid) {
  // Doubles of round numbers differ only in their high bits.
  std::set<uint64_t> slots;
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 32; ++y)
      slots.insert(PointHash::OfProcess()({std::bit_cast<uint64_t>(double(x)),
                                           std::bit_cast<uint64_t>(double(y)), 0}) &
                   0xffff);
  EXPECT_GT(slots.size(), 900u);  // 1016 of 1024 are to be expected
}

}  // namespace
}  // namespace slicefarm::slicing::weld_test
