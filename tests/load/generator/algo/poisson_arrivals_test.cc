#include "tests/load/generator/algo/poisson_arrivals.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::load::poisson_arrivals_test {
namespace {

std::vector<int64_t> Arrivals(double rate_rps, uint64_t seed, int number) {
  PoissonArrivals arrivals(rate_rps, seed);
  std::vector<int64_t> instants;
  for (int i = 0; i < number; ++i) instants.push_back(arrivals.NextNs());
  return instants;
}

/// Returns the number of arrivals in each second.
std::vector<int> CountsPerSecond(const std::vector<int64_t>& instants, int seconds) {
  std::vector<int> counts(seconds);
  for (const int64_t at : instants) {
    if (at / 1'000'000'000 < seconds) ++counts[at / 1'000'000'000];
  }
  return counts;
}

class PoissonArrivalsTest : public testing::TestWithParam<uint64_t> {};

// In a Poisson process, the rate is both the mean and the variance of the counts per second, and
// the mean gap is also the standard deviation of the gaps. Regular arrivals have neither property.
TEST_P(PoissonArrivalsTest, CountsHaveTheRateAsMeanAndVariance) {
  constexpr double kRate = 20;
  constexpr int kSeconds = 5'000;
  const auto counts = CountsPerSecond(Arrivals(kRate, GetParam(), 110'000), kSeconds);
  double mean = 0, variance = 0;
  for (const int count : counts) mean += static_cast<double>(count) / kSeconds;
  for (const int count : counts) variance += (count - mean) * (count - mean) / (kSeconds - 1);
  // Five standard deviations: sqrt(rate / n), and about rate * sqrt(2 / n).
  EXPECT_NEAR(mean, kRate, 0.32);
  EXPECT_NEAR(variance, kRate, 2.0);
}

TEST_P(PoissonArrivalsTest, GapsAreExponential) {
  constexpr double kRate = 500;
  constexpr int kNumber = 100'000;
  const auto instants = Arrivals(kRate, GetParam(), kNumber);
  int64_t before = 0;
  int longer_than_mean = 0;
  double squares = 0;
  for (const int64_t at : instants) {
    ASSERT_GE(at, before);
    const double gap_s = static_cast<double>(at - before) / 1e9;
    squares += gap_s * gap_s;
    longer_than_mean += gap_s > 1 / kRate;
    before = at;
  }
  EXPECT_NEAR(squares / kNumber * kRate * kRate, 2, 0.1);
  EXPECT_NEAR(static_cast<double>(longer_than_mean) / kNumber, 0.3679, 0.008);
}

INSTANTIATE_TEST_SUITE_P(Seeds, PoissonArrivalsTest, testing::Values(1, 2, 3, 0xffffffffffff));

TEST(PoissonArrivals, TheSeedDecides) {
  EXPECT_EQ(Arrivals(10, 5, 100), Arrivals(10, 5, 100));
  EXPECT_NE(Arrivals(10, 5, 100), Arrivals(10, 6, 100));
}

}  // namespace
}  // namespace slicefarm::load::poisson_arrivals_test
