#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::load {

/// Counts of durations, in buckets whose width grows with the duration: a percentile is at most
/// kRelativeError too high and never too low, from 1 ns to 292 years.
/// Cost: 64 kB; Record O(1). Source: G. Tene's HdrHistogram.
class LatencyHistogram {
 public:
  static constexpr double kRelativeError = 1.0 / 128;

  LatencyHistogram();

  /// A negative duration counts as 0.
  void Record(int64_t ns);

  int64_t count() const { return count_; }
  int64_t min_ns() const { return count_ == 0 ? 0 : min_ns_; }
  int64_t max_ns() const { return max_ns_; }
  double mean_ns() const;

  /// The least duration, rounded up within its bucket, that `percent` of all reach not or just:
  /// nearest rank. 0 without any. REQUIRES: 0 <= percent <= 100.
  int64_t PercentileNs(double percent) const;

  /// How many lie at or below `ns`, whose whole bucket is counted in.
  int64_t CountUpTo(int64_t ns) const;

 private:
  std::vector<int64_t> buckets_;
  int64_t count_ = 0;
  int64_t min_ns_ = 0;
  int64_t max_ns_ = 0;
  double sum_ns_ = 0;
};

}  // namespace slicefarm::load
