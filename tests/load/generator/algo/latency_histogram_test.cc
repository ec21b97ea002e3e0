#include "tests/load/generator/algo/latency_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/load/generator/algo/seeded.h"

namespace slicefarm::load::latency_histogram_test {
namespace {

constexpr double kPercents[] = {0, 1, 10, 50, 90, 95, 99, 99.9, 99.99, 100};

LatencyHistogram HistogramOf(const std::vector<int64_t>& values) {
  LatencyHistogram histogram;
  for (const int64_t value : values) histogram.Record(value);
  return histogram;
}

int64_t NearestRank(const std::vector<int64_t>& sorted, double percent) {
  const auto rank = static_cast<size_t>(std::ceil(percent / 100 * sorted.size()));
  return sorted[std::clamp<size_t>(rank, 1, sorted.size()) - 1];
}

/// Returns durations from nanoseconds to hours, with equal numbers per order of magnitude.
std::vector<int64_t> LogUniform(uint64_t seed, int number) {
  SeededRandom random(seed);
  std::vector<int64_t> values;
  for (int i = 0; i < number; ++i)
    values.push_back(std::llround(std::pow(10, random.Uniform(0, 13))));
  return values;
}

TEST(LatencyHistogram, PercentilesAreWithinTheErrorOfASort) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<int64_t> values = LogUniform(seed, 20'000);
    const LatencyHistogram histogram = HistogramOf(values);
    std::sort(values.begin(), values.end());
    for (const double percent : kPercents) {
      const auto exact = static_cast<double>(NearestRank(values, percent));
      const auto got = static_cast<double>(histogram.PercentileNs(percent));
      EXPECT_GE(got, exact) << percent;
      EXPECT_LE(got, exact * (1 + LatencyHistogram::kRelativeError)) << percent;
    }
  }
}

TEST(LatencyHistogram, ShortDurationsAreExact) {
  LatencyHistogram histogram;
  for (int64_t ns = 0; ns < 256; ++ns) histogram.Record(ns);
  for (int rank = 1; rank <= 256; ++rank) {
    EXPECT_EQ(histogram.PercentileNs(rank / 2.56), rank - 1) << rank;
  }
}

TEST(LatencyHistogram, ExtremesAreKept) {
  constexpr int64_t kLongest = std::numeric_limits<int64_t>::max();
  const LatencyHistogram histogram = HistogramOf({-5, 3, kLongest});
  EXPECT_EQ(histogram.count(), 3);
  EXPECT_EQ(histogram.min_ns(), 0);
  EXPECT_EQ(histogram.max_ns(), kLongest);
  EXPECT_EQ(histogram.PercentileNs(0), 0);
  EXPECT_EQ(histogram.PercentileNs(50), 3);
  EXPECT_EQ(histogram.PercentileNs(100), kLongest);
}

TEST(LatencyHistogram, NoneIsZero) {
  const LatencyHistogram histogram;
  EXPECT_EQ(histogram.PercentileNs(99), 0);
  EXPECT_EQ(histogram.max_ns(), 0);
  EXPECT_EQ(histogram.mean_ns(), 0);
}

TEST(LatencyHistogram, MeanIsExact) {
  EXPECT_DOUBLE_EQ(HistogramOf({1'000'000, 2'000'001, 6'000'002}).mean_ns(), 3'000'001);
}

TEST(LatencyHistogram, CountUpToIsWithinABucket) {
  std::vector<int64_t> values = LogUniform(1, 10'000);
  const LatencyHistogram histogram = HistogramOf(values);
  std::sort(values.begin(), values.end());
  const auto up_to = [&](double ns) {
    return std::upper_bound(values.begin(), values.end(), ns) - values.begin();
  };
  for (double ns = 1; ns < 1e13; ns *= 1.7) {
    const int64_t count = histogram.CountUpTo(static_cast<int64_t>(ns));
    EXPECT_GE(count, up_to(std::floor(ns)));
    EXPECT_LE(count, up_to(ns * (1 + LatencyHistogram::kRelativeError)));
  }
  EXPECT_EQ(histogram.CountUpTo(-1), 0);
}

}  // namespace
}  // namespace slicefarm::load::latency_histogram_test
