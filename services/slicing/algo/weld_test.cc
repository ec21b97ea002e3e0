#include "services/slicing/algo/weld.h"

#include <gtest/gtest.h>

#include "common/model/mesh.h"

namespace slicefarm::slicing {
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

}  // namespace
}  // namespace slicefarm::slicing
