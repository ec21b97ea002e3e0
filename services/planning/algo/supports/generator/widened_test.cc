#include "services/planning/algo/supports/generator/widened.h"

#include <gtest/gtest.h>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::widened_test {
namespace {

TEST(Widened, OnlyNarrowIslands) {
  const MultiPolygon strip = BoxOf(0, 0, 10, 0.2), square = BoxOf(20, 0, 21, 1);
  EXPECT_TRUE(Widened(square, 400'000).empty());
  const MultiPolygon wide = Widened(Union(strip, square), 400'000);
  ASSERT_EQ(wide.size(), 1u);
  EXPECT_NEAR(ToMm(Bounds(wide).max.y - Bounds(wide).min.y), 0.4, 0.02);
}

}  // namespace
}  // namespace slicefarm::planning::widened_test
