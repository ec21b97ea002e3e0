#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::rpc {

/// Limits on the number of log lines.
struct LineLimits {
  double burst = 20;  ///< largest number of lines with the same message that are written at once
  double lines_per_s = 1;  ///< maximum average rate of lines with the same message
  /// Number of different messages that have separate limits; all further messages share one limit.
  size_t max_messages = 256;
};

/// Decides which log lines are written, with a token bucket for each message. An error that occurs
/// a thousand times per second thus cannot fill a disk. The caller provides the time. Not
/// thread-safe.
class LineLimiter {
 public:
  explicit LineLimiter(const LineLimits& limits = {}) : limits_(limits) {}

  /// Decides about a line with this message at time `now_s`. Returns nullopt if the line is
  /// omitted. Otherwise returns the number of lines that were omitted since the last written line
  /// with this message.
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
