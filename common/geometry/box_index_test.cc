#include "common/geometry/box_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "common/geometry/text_format_test.h"

namespace slicefarm::box_index_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Box RandomBox(std::mt19937& random, Coord largest) {
  const auto draw = [&](Coord below) {
    return static_cast<Coord>(random() % static_cast<uint32_t>(below));
  };
  const Point low{draw(1000) - 500, draw(1000) - 500};
  return {low, {low.x + draw(largest), low.y + draw(largest)}};
}

TEST(BoxIndex, FindsWhatASearchThroughAllFinds) {
  std::mt19937 random(3);
  for (const size_t count : {0, 1, 2, 8, 9, 17, 300}) {
    std::vector<Box> boxes;
    for (size_t i = 0; i < count; ++i) boxes.push_back(RandomBox(random, i % 20 == 0 ? 400 : 30));
    const BoxIndex index(boxes);
    for (int trial = 0; trial < 200; ++trial) {
      const Box query = RandomBox(random, 100);
      std::vector<size_t> want;
      for (size_t i = 0; i < count; ++i)
        if (boxes[i].Intersects(query)) want.push_back(i);
      ASSERT_EQ(index.Meeting(query), want) << count << " " << trial;
    }
  }
}

TEST(BoxIndex, EqualAndEmptyBoxes) {
  std::vector<Box> boxes(100, Box{{5, 5}, {5, 5}});
  boxes[7] = {};
  const BoxIndex index(boxes);
  EXPECT_EQ(index.Meeting({{0, 0}, {5, 5}}).size(), 99u);
  EXPECT_THAT(index.Meeting({{6, 6}, {9, 9}}), IsEmpty());
  EXPECT_THAT(index.Meeting({}), IsEmpty());
}

TEST(BoxIndex, FindsIslandsInTheirOrder) {
  const MultiPolygon islands = MakePolygonsOrDie(
      "(0 0, 1 0, 1 1, 0 1) ; (5 0, 6 0, 6 1, 5 1) ; (1.5 0, 2.5 0, 2.5 1, 1.5 1)");
  const BoxIndex index(islands);
  const Box query = {{FromMm(0.5), FromMm(0.5)}, {FromMm(2), FromMm(0.5)}};
  EXPECT_THAT(IslandsNear(query, islands, index), ElementsAre(islands[0], islands[2]));
}

}  // namespace
}  // namespace slicefarm::box_index_test
