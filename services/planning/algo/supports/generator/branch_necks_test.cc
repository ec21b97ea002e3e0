#include "services/planning/algo/supports/generator/branch_necks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"

namespace slicefarm::planning::branch_necks_test {
namespace {

struct Case {
  const char* name;
  std::vector<BranchDisc> discs;  ///< ascending; in mm
  std::vector<BranchNeck> necks;
};

BranchDisc Disc(double x, double y, double radius = 1) {
  return {{FromMm(x), FromMm(y)}, FromMm(radius)};
}

class NecksBetweenTest : public testing::TestWithParam<Case> {};

TEST_P(NecksBetweenTest, JoinsStrings) {
  EXPECT_EQ(NecksBetween(GetParam().discs), GetParam().necks);
}

INSTANTIATE_TEST_SUITE_P(
    Discs, NecksBetweenTest,
    testing::Values(
        Case{"None", {}, {}}, Case{"One", {Disc(0, 0)}, {}},
        Case{"Near", {Disc(0, 0), Disc(3.4, 0)}, {{0, 1}}},
        Case{"Far", {Disc(0, 0), Disc(3.6, 0)}, {}},
        Case{"Overlapping", {Disc(0, 0), Disc(1, 0)}, {{0, 1}}},
        Case{"OneInTheOther", {Disc(0, 0, 2), Disc(0.5, 0, 0.5)}, {}},
        Case{"NearBesideAFarLargeOne", {Disc(0, 0), Disc(3, 9, 5), Disc(3.2, 0)}, {{0, 2}}},
        Case{"Row", {Disc(0, 0), Disc(3, 0), Disc(6, 0), Disc(9, 0)}, {{0, 1}, {1, 2}, {2, 3}}},
        Case{"NoRing", {Disc(0, 0), Disc(0, 3), Disc(2, 1.4)}, {{0, 2}, {1, 2}}},
        Case{"TwoNecksAtMost",
             {Disc(-2.5, 0), Disc(0, 0), Disc(0.1, 3.4), Disc(2.6, 0)},
             {{0, 1}, {1, 3}}}),
    [](const auto& info) { return info.param.name; });

TEST(OutlineOfNeck, MakesTwoDiscsOneIsland) {
  for (const double radius : {0.4, 1.0, 3.0}) {
    const BranchDisc a = Disc(0, 0, radius), b = Disc(2, 2 * radius + 1, radius);
    const Polygon neck = OutlineOfNeck(a, b);
    const double width = 2 * std::min(radius, 0.9);
    EXPECT_NEAR(Area({neck, {}}) / 1e12, width * ToMm(Distance(a.at, b.at)), 1e-3) << radius;
    EXPECT_NEAR(ToMm(Distance(neck[0], neck[3])), width, 1e-5) << radius;
  }
}

}  // namespace
}  // namespace slicefarm::planning::branch_necks_test
