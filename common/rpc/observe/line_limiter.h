#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::rpc {

struct LineLimits {
  double burst = 20;          ///< lines of one message at once
  double lines_per_s = 1;     ///< of one message in the long run
  size_t max_messages = 256;  ///< told apart; more of them share one limit
};

/// Which log lines to write, so that what fails a thousand times a second does not fill a disk: a
/// token bucket for each message. The clock is the caller's. Not thread-safe.
class LineLimiter {
 public:
  explicit LineLimiter(const LineLimits& limits = {}) : limits_(limits) {}

  /// Whether a line with this message is to be written; and if so, how many before it were not.
  std::optional<int64_t> Pass(std::string_view message, double now_s);

 private:
  struct Bucket {
    double tokens = 0;
    double since_s = 0;
    int64_t suppressed = 0;
  };
  Bucket& BucketOf(std::string_view message, double now_s);

  LineLimits limits_;
  std::map<std::string, Bucket, std::less<>> buckets_;
};

}  // namespace slicefarm::rpc
