#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// Rate limits by name, each a token bucket. On average a name gets `per_second` units per second;
/// after a pause, it gets the units of two seconds at once. Thread-safe.
class RateLimits {
 public:
  /// Takes `count` units if the bucket is not empty, and returns 0. `count` may exceed the content
  /// of the bucket; the next Take must then wait for the difference. If the bucket is empty, takes
  /// nothing and returns the time in us until it has content. REQUIRES: per_second >= 1, count >=
  /// 1.
  int64_t Take(const std::string& name, int64_t per_second, int64_t count, int64_t now_us);

 private:
  struct Bucket {
    /// Content of the bucket, as the time in us in which this content accumulates. Negative after a
    /// Take of more units than the content.
    int64_t left_us = 0;
    int64_t at_us = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace slicefarm::coordinator
