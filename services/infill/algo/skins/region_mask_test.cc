#include "services/infill/algo/skins/region_mask.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::region_mask_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

struct Case {
  std::string name;
  std::string outlines;
  bool want;
};
class Meets : public testing::TestWithParam<Case> {};

// A frame from 10 to 30 with a hole from 16 to 24.
TEST_P(Meets, OnlyWhatComesNear) {
  const RegionMask mask(P("(10 10, 30 10, 30 30, 10 30) (16 16, 24 16, 24 24, 16 24)"));
  EXPECT_EQ(mask.MayMeet(P(GetParam().outlines)), GetParam().want);
}

INSTANTIATE_TEST_SUITE_P(
    RegionMask, Meets,
    testing::Values(Case{"AllAround", "(8 8, 32 8, 32 32, 8 32)", false},
                    Case{"InTheHole", "(18 18, 22 18, 22 22, 18 22)", false},
                    Case{"FarAway", "(100 10, 120 10, 120 30)", false}, Case{"Nothing", "", false},
                    Case{"AcrossTheFrame", "(0 0, 13 0, 13 40, 0 40)", true},
                    Case{"WithinTheFrame", "(12 12, 13 12, 13 13, 12 13)", true},
                    Case{"HoleOfACoverInTheFrame", "(0 0, 40 0, 40 40, 0 40) (27 27, 28 27, 28 28)",
                         true},
                    Case{"LongEdgeThroughEverything", "(-1000 5, 1000 35, -1000 36)", true},
                    Case{"LongEdgePast", "(-1000 -50, 1000 0, -1000 0)", false}),
    [](const auto& info) { return info.param.name; });

TEST(RegionMaskOfNothing, MeetsNothing) {
  EXPECT_FALSE(RegionMask(MultiPolygon()).MayMeet(P("(0 0, 1 0, 1 1)")));
}

// The mask may return true too often, but never false if an edge meets the region.
TEST(RegionMaskSafety, NeverMissesAMeeting) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto blob = [&](double x, double y, double size) {
    Polygon ring;
    for (int i = 0; i < 17; ++i) {
      const double t = 2 * std::numbers::pi * i / 17, r = size * (0.4 + unit(random));
      ring.push_back({FromMm(x + r * std::cos(t)), FromMm(y + r * std::sin(t))});
    }
    return MultiPolygon{{ring, {}}};
  };
  int missed = 0, apart = 0;
  for (int i = 0; i < 500; ++i) {
    const MultiPolygon region = blob(0, 0, 3), other = blob(8 * unit(random), 8 * unit(random), 3);
    if (RegionMask(region).MayMeet(other)) continue;
    ++apart;
    const size_t common = Intersection(region, other).size();
    missed += common != 0 && Intersection(region, other) != region;
  }
  EXPECT_EQ(missed, 0);
  EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace slicefarm::infill::region_mask_test
