#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// How many of something each of many names may have a second (a token bucket each): on average
/// `per_second`, and after a pause as many at once as two seconds allow. Thread-safe.
class RateLimits {
 public:
  /// Takes `count` at once if there is anything left; what is taken beyond that is paid back before
  /// the next ones. Returns 0, or if nothing is left the time until something is, in us.
  /// REQUIRES: per_second >= 1, count >= 1.
  int64_t Take(const std::string& name, int64_t per_second, int64_t count, int64_t now_us);

 private:
  struct Bucket {
    int64_t left_us = 0;  ///< what is left, times the time that one takes to come
    int64_t at_us = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace slicefarm::coordinator
