#include "common/geometry/vector.h"

#include <gtest/gtest.h>

namespace slicefarm::vector_test {
namespace {

TEST(Vector2, ProductsAndTurns) {
  const Vector2 a(3, 4), b(-2, 5);
  EXPECT_EQ(Dot(a, b), 14);
  EXPECT_EQ(Cross(a, b), 23);
  EXPECT_EQ(TurnedLeft(a), Vector2(-4, 3));
  EXPECT_EQ(Cross(a, TurnedLeft(a)), a.squaredNorm());
}

}  // namespace
}  // namespace slicefarm::vector_test
