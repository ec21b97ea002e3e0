#include "common/model/spiral.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/measure.h"

namespace slicefarm::spiral_test {
namespace {

using ::testing::DoubleNear;
using ::testing::Eq;
using ::testing::Optional;

constexpr Coord kWidth = 450'000;

Polygon Rectangle(double x_mm, double y_mm, double wide_mm, double high_mm) {
  const Point low{FromMm(x_mm), FromMm(y_mm)}, high{FromMm(x_mm + wide_mm), FromMm(y_mm + high_mm)};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

TEST(SpiralLoop, RunsHalfAWidthInside) {
  const auto loop = SpiralLoop({{Rectangle(0, 0, 10, 20), {}}}, kWidth);
  ASSERT_TRUE(loop);
  EXPECT_THAT(SignedArea(*loop) / 1e12, DoubleNear(9.55 * 19.55, 1e-6));
}

TEST(SpiralLoop, NoneWhereOneBeadCannotGoRoundAll) {
  const PolygonWithHoles plain{Rectangle(0, 0, 10, 20), {}};
  Polygon hole = Rectangle(3, 3, 2, 2);
  std::ranges::reverse(hole);
  const struct {
    const char* name;
    MultiPolygon outline;
  } cases[] = {
      {"nothing", {}},
      {"two islands", {plain, {Rectangle(20, 0, 5, 5), {}}}},
      {"a hole", {{Rectangle(0, 0, 10, 20), {hole}}}},
      {"narrower than a bead", {{Rectangle(0, 0, 10, .4), {}}}},
      {"a neck",
       {{{{FromMm(0), FromMm(0)},
          {FromMm(10), FromMm(0)},
          {FromMm(10), FromMm(4)},
          {FromMm(20), FromMm(4)},
          {FromMm(20), FromMm(0)},
          {FromMm(30), FromMm(0)},
          {FromMm(30), FromMm(10)},
          {FromMm(20), FromMm(10)},
          {FromMm(20), FromMm(4.3)},
          {FromMm(10), FromMm(4.3)},
          {FromMm(10), FromMm(10)},
          {FromMm(0), FromMm(10)}},
         {}}}},
  };
  for (const auto& [name, outline] : cases)
    EXPECT_THAT(SpiralLoop(outline, kWidth), Eq(std::nullopt)) << name;
}

}  // namespace
}  // namespace slicefarm::spiral_test
