#include "common/rpc/observe/line_limiter.h"

#include <algorithm>
#include <utility>

namespace slicefarm::rpc {

LineLimiter::Bucket& LineLimiter::BucketOf(std::string_view message, double now_s) {
  if (const auto known = buckets_.find(message); known != buckets_.end()) return known->second;
  if (buckets_.size() >= limits_.max_messages) message = "";
  return buckets_.try_emplace(std::string(message), Bucket{limits_.burst, now_s, 0}).first->second;
}

std::optional<int64_t> LineLimiter::Pass(std::string_view message, double now_s) {
  Bucket& bucket = BucketOf(message, now_s);
  bucket.tokens =
      std::min(limits_.burst, bucket.tokens + (now_s - bucket.since_s) * limits_.lines_per_s);
  bucket.since_s = now_s;
  if (bucket.tokens < 1) {
    ++bucket.suppressed;
    return std::nullopt;
  }
  bucket.tokens -= 1;
  return std::exchange(bucket.suppressed, 0);
}

}  // namespace slicefarm::rpc
