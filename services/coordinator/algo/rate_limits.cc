#include "services/coordinator/algo/rate_limits.h"

#include <algorithm>

namespace slicefarm::coordinator {
namespace {

/// Largest content of a bucket: two seconds' worth of units
constexpr int64_t kFullUs = 2'000'000;

}  // namespace

int64_t RateLimits::Take(const std::string& name, int64_t per_second, int64_t count,
                         int64_t now_us) {
  const std::lock_guard lock(mutex_);
  const auto [found, fresh] = buckets_.try_emplace(name, Bucket{kFullUs, now_us});
  Bucket& bucket = found->second;
  const int64_t passed_us = std::max<int64_t>(now_us - bucket.at_us, 0);
  bucket.left_us = std::min(bucket.left_us + passed_us, kFullUs);
  bucket.at_us = now_us;
  if (bucket.left_us <= 0) return 1 - bucket.left_us;
  bucket.left_us -= count * 1'000'000 / per_second;
  return 0;
}

}  // namespace slicefarm::coordinator
