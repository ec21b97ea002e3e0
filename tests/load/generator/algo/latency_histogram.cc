#include "tests/load/generator/algo/latency_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace slicefarm::load {
namespace {

/// Each power of two is divided into 2^kSubBits buckets.
constexpr int kSubBits = 7;
static_assert(LatencyHistogram::kRelativeError == 1.0 / (1 << kSubBits));
constexpr int kMaxShift = 63 - (kSubBits + 1);
constexpr size_t kBuckets = (kMaxShift + 2) << kSubBits;

size_t BucketOf(int64_t ns) {
  const auto value = static_cast<uint64_t>(ns);
  const int shift = std::max(0, static_cast<int>(std::bit_width(value)) - (kSubBits + 1));
  return (static_cast<size_t>(shift) << kSubBits) + (value >> shift);
}

int64_t LargestOf(size_t bucket) {
  const int shift = std::max(0, static_cast<int>(bucket >> kSubBits) - 1);
  const uint64_t value = bucket - (static_cast<size_t>(shift) << kSubBits);
  return static_cast<int64_t>(((value + 1) << shift) - 1);
}

}  // namespace

LatencyHistogram::LatencyHistogram() : buckets_(kBuckets) {}

void LatencyHistogram::Record(int64_t ns) {
  ns = std::max<int64_t>(ns, 0);
  ++buckets_[BucketOf(ns)];
  min_ns_ = count_ == 0 ? ns : std::min(min_ns_, ns);
  max_ns_ = std::max(max_ns_, ns);
  sum_ns_ += static_cast<double>(ns);
  ++count_;
}

double LatencyHistogram::mean_ns() const {
  return count_ == 0 ? 0 : sum_ns_ / static_cast<double>(count_);
}

int64_t LatencyHistogram::PercentileNs(double percent) const {
  if (count_ == 0) return 0;
  const auto rank = static_cast<int64_t>(std::ceil(percent / 100 * static_cast<double>(count_)));
  int64_t left = std::clamp<int64_t>(rank, 1, count_);
  size_t bucket = 0;
  while (left > buckets_[bucket]) left -= buckets_[bucket++];
  return std::min(LargestOf(bucket), max_ns_);
}

int64_t LatencyHistogram::CountUpTo(int64_t ns) const {
  if (ns < 0) return 0;
  const auto end = buckets_.begin() + static_cast<std::ptrdiff_t>(BucketOf(ns)) + 1;
  return std::accumulate(buckets_.begin(), end, int64_t{0});
}

}  // namespace slicefarm::load
