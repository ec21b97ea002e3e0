#include "services/milling/algo/push/bull_push.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::bull_push_test {
namespace {

double EndAt(const ProfilePiece& arc, const FiberPoint& from, const FiberPoint& step, double s,
             double side) {
  const double height = from.height + s * step.height, across = from.across + s * step.across;
  const double width =
      arc.flat_mm + std::sqrt(std::max(0.0, height * (2 * arc.corner_mm - height)));
  const double square = width * width - across * across;
  return square > 0 ? side * (from.along + s * step.along) + std::sqrt(square) : -1e9;
}

/// No point of the edge reaches farther than the result, even if the result is next to the tip,
/// where the width grows without bound.
TEST(BullContact, ReachesFarthest) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1), any(-3, 3);
  for (int round = 0; round < 3000; ++round) {
    const double corner = 0.1 + share(random);
    const ProfilePiece arc{.to_mm = corner, .corner_mm = corner, .flat_mm = 0.5};
    const double h0 = round % 3 == 0 ? 0 : corner * share(random),
                 h1 = round % 7 == 0 ? h0 : corner * share(random);
    const FiberPoint from{any(random), any(random), h0};
    const FiberPoint step{any(random) * (round % 5 == 0 ? 100 : 1), any(random), h1 - h0};
    for (const double side : {1.0, -1.0}) {
      const double s = BullContact(arc, from, step, 1, side), end = EndAt(arc, from, step, s, side);
      ASSERT_TRUE(s >= 0 && s <= 1);
      for (int i = 0; i <= 2000; ++i) {
        const double t = i < 1000 ? std::pow(0.97, i) : (i - 1000) / 1000.0;
        EXPECT_GE(end, EndAt(arc, from, step, t, side) - 1e-10) << round << " " << s << " " << t;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::milling::bull_push_test
