#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// Rate limits by name, each a token bucket. On average a name gets `per_second` units; after a
/// pause, it gets two seconds' worth at once. Thread-safe.
class RateLimits {
 public:
  /// Takes `count` units at once if any are left. Units beyond the content of the bucket are paid
  /// back before the next Take. Returns 0, or, if none are left, the time until one is, in us.
  /// REQUIRES: per_second >= 1, count >= 1.
  int64_t Take(const std::string& name, int64_t per_second, int64_t count, int64_t now_us);

 private:
  struct Bucket {
    int64_t left_us = 0;  ///< units left, as the time in which they accumulate
    int64_t at_us = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace slicefarm::coordinator
