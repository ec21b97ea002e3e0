#include "services/texture/algo/paths/boundary_margin.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::boundary_margin_test {
namespace {

TEST(BoundaryMargin, KeepsOffBoundaryAndHoles) {
  const SurfaceMap map = MapFromAbove(SquareWithHole(10, 10));  // a hole from 3 to 7
  const BoundaryMargin margin(map, 1);
  EXPECT_TRUE(margin.Contains({1.5, 1.5}));
  EXPECT_FALSE(margin.Contains({0.9, 5}));
  EXPECT_TRUE(margin.Contains({1.1, 5}));
  EXPECT_FALSE(margin.Contains({2.5, 5}));
  EXPECT_FALSE(margin.Contains({2.4, 2.4})) << "round a corner";
  EXPECT_TRUE(margin.Contains({2.2, 2.2}));
}

TEST(BoundaryMargin, NothingChangesBetweenItsCuts) {
  const SurfaceMap map = MapFromAbove(SquareWithHole(10, 10));
  for (const double mm : {0.01, 0.3, 1.2}) {
    const BoundaryMargin margin(map, mm);
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector2d a(i * 0.2 + 0.013, 0), b(9.7 - i * 0.17, 10);
      std::vector<double> shares = {0, 1};
      margin.Cuts(a, b, &shares);
      std::sort(shares.begin(), shares.end());
      EXPECT_GE(shares.size(), 4u);
      for (size_t k = 0; k + 1 < shares.size(); ++k) {
        if (shares[k + 1] - shares[k] < 1e-9) continue;
        const auto at = [&](double t) {
          return margin.Contains(a + (shares[k] + t * (shares[k + 1] - shares[k])) * (b - a));
        };
        EXPECT_EQ(at(0.001), at(0.5));
        EXPECT_EQ(at(0.999), at(0.5));
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::texture::boundary_margin_test
