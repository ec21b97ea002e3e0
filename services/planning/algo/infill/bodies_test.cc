#include "services/planning/algo/infill/bodies.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::bodies_test {
namespace {

MultiPolygon P(const char* text) { return MakePolygonsOrDie(text); }

TEST(BodyMiddles, SeparateTowersHaveTheirOwn) {
  const auto middles =
      BodyMiddles(Prism(5, "(0 0, 10 0, 10 10, 0 10); (20 0, 30 0, 30 20, 20 20)"));
  ASSERT_EQ(middles.size(), 5u);
  for (const auto& layer : middles)
    EXPECT_EQ(layer, (std::vector<Point>{{5'000'000, 5'000'000}, {25'000'000, 10'000'000}}));
}

// Two legs under one plate, and an island that is alone.
TEST(BodyMiddles, IslandsThatMeetInAnyLayerAreOneBody) {
  const auto stack = StackOf(6, [](int i) {
    return i < 4 ? P("(0 0, 4 0, 4 4, 0 4); (16 0, 20 0, 20 4, 16 4); (40 0, 44 0, 44 4, 40 4)")
                 : P("(0 0, 20 0, 20 4, 0 4); (40 0, 44 0, 44 4, 40 4)");
  });
  const auto middles = BodyMiddles(stack);
  const Point plate{10'000'000, 2'000'000}, alone{42'000'000, 2'000'000};
  EXPECT_EQ(middles[0], (std::vector<Point>{plate, plate, alone}));
  EXPECT_EQ(middles[5], (std::vector<Point>{plate, alone}));
}

// A ring around a post never touches it.
TEST(BodyMiddles, InterleavedPartsStayApart) {
  const auto middles = BodyMiddles(
      Prism(3, "(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5); (8 8, 11 8, 11 11, 8 11)"));
  EXPECT_EQ(middles[2], (std::vector<Point>{{10'000'000, 10'000'000}, {9'500'000, 9'500'000}}));
}

}  // namespace
}  // namespace slicefarm::planning::bodies_test
