#include "services/beading/algo/noise/coherent_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace slicefarm::beading::coherent_noise_test {
namespace {

struct NoiseCase {
  const char* name;
  double (*value)(const Vector3&);
  /// Largest change over a thousandth of a feature.
  double steepest;
};

std::string CaseName(const testing::TestParamInfo<NoiseCase>& info) { return info.param.name; }

class Noise : public testing::TestWithParam<NoiseCase> {};
INSTANTIATE_TEST_SUITE_P(
    All, Noise,
    testing::Values(NoiseCase{"Gradient", [](const Vector3& at) { return GradientNoise(at, 3); },
                              0.005},
                    NoiseCase{"Perlin",
                              [](const Vector3& at) {
                                return PerlinNoise(at, {4, 0.5});
                              },
                              0.02},
                    NoiseCase{"Billow",
                              [](const Vector3& at) {
                                return BillowNoise(at, {4, 0.5});
                              },
                              0.04},
                    NoiseCase{"Ridged", [](const Vector3& at) { return RidgedNoise(at, 4); }, 0.1}),
    CaseName);

// Values use most of [-1, 1], are never beyond, and change smoothly.
TEST_P(Noise, FillsItsRangeSmoothly) {
  double least = 1, most = -1, sum = 0;
  constexpr int kSamples = 20'000;
  for (int i = 0; i < kSamples; ++i) {
    const Vector3 at{0.37 * i, -0.61 * i, 0.013 * i};
    const double value = GetParam().value(at);
    least = std::min(least, value);
    most = std::max(most, value);
    sum += value;
    const double beside = GetParam().value({at.x() + 0.001, at.y(), at.z()});
    EXPECT_LE(std::abs(value - beside), GetParam().steepest);
  }
  EXPECT_GE(least, -1);
  EXPECT_LE(most, 1);
  EXPECT_LT(least, -0.6);
  EXPECT_GT(most, 0.6);
  EXPECT_LT(std::abs(sum / kSamples), 0.6);  // lumps and ridges are above a wide low ground
}

TEST(GradientNoise, IsZeroAtWholePointsAndDependsOnTheSeed) {
  EXPECT_EQ(GradientNoise({3, -7, 2}, 1), 0);
  EXPECT_NE(GradientNoise({3.4, -7.2, 2.1}, 1), GradientNoise({3.4, -7.2, 2.1}, 2));
}

TEST(PerlinNoise, MoreOctavesAndMorePersistenceAreRougher) {
  const auto roughness = [](const Octaves& octaves) {
    double sum = 0;
    for (int i = 0; i < 5000; ++i) {
      const Vector3 at{0.31 * i, 0.17 * i, 0};
      sum += std::abs(PerlinNoise({at.x() + 0.02, at.y(), 0}, octaves) - PerlinNoise(at, octaves));
    }
    return sum;
  };
  EXPECT_GT(roughness({4, 0.5}), 1.3 * roughness({1, 0.5}));
  EXPECT_GT(roughness({4, 0.8}), 1.3 * roughness({4, 0.5}));
}

// Nearly all steps of a line stay within a cell. A few steps lead into another cell.
TEST(VoronoiNoise, IsConstantInCells) {
  std::set<double> values;
  int changes = 0;
  double last = VoronoiNoise({0, 0.3, 0.7});
  for (int i = 1; i < 2000; ++i) {
    const double value = VoronoiNoise({0.01 * i, 0.3, 0.7});
    EXPECT_LE(std::abs(value), 1);
    if (value != last) ++changes;
    values.insert(value);
    last = value;
  }
  EXPECT_GT(changes, 10);
  EXPECT_LT(changes, 60);
  EXPECT_GT(values.size(), 10u);
}

}  // namespace
}  // namespace slicefarm::beading::coherent_noise_test
