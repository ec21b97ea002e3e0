#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::load {

/// Histogram of durations. The width of a bucket grows with the duration: a percentile is at most
/// kRelativeError too high and never too low, from 1 ns to 292 years. Cost: 64 kB; Record O(1).
/// Source: G. Tene's HdrHistogram.
class LatencyHistogram {
 public:
  static constexpr double kRelativeError = 1.0 / 128;

  LatencyHistogram();

  /// Adds a duration. A negative duration counts as 0.
  void Record(int64_t ns);

  /// Returns the number of durations.
  int64_t count() const { return count_; }
  /// Returns the smallest duration; 0 without any.
  int64_t min_ns() const { return count_ == 0 ? 0 : min_ns_; }
  /// Returns the largest duration.
  int64_t max_ns() const { return max_ns_; }
  /// Returns the mean duration.
  double mean_ns() const;

  /// Returns the smallest duration that at least `percent` of all do not exceed (nearest rank),
  /// rounded up within its bucket. Returns 0 without any. REQUIRES: 0 <= percent <= 100.
  int64_t PercentileNs(double percent) const;

  /// Returns the number of durations up to `ns`. Includes all durations in the bucket of `ns`.
  int64_t CountUpTo(int64_t ns) const;

 private:
  std::vector<int64_t> buckets_;
  int64_t count_ = 0;
  int64_t min_ns_ = 0;
  int64_t max_ns_ = 0;
  double sum_ns_ = 0;
};

}  // namespace slicefarm::load
