#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "tests/load/generator/algo/latency_histogram.h"

namespace slicefarm::load {

/// Outcome of a request. `step`: call that returned the error, such as "CreateJob".
struct Outcome {
  absl::Status status = {};
  std::string step = {};
  bool says_when_to_retry = false;  ///< true if the error contains RetryInfo
};

/// Request that has ended.
struct Sample {
  int64_t intended_ns = 0;  ///< intended start, from the beginning of the run
  int64_t latency_ns = 0;   ///< time from the intended start to the end
  absl::StatusCode code = absl::StatusCode::kOk;
  std::string error;  ///< error of the request; empty: the request succeeded
};

/// Kinds of counts in addition to requests.
enum class Tally { kRetries, kEvents, kCachedJobs, kBytesSent, kBytesReceived };
inline constexpr int kTallies = 5;

/// Counts and durations of a run.
struct RunRecord {
  int64_t arrivals = 0;  ///< requests that were due
  int64_t skipped = 0;   ///< requests that were not started, because too many were in flight
  int64_t end_ns = 0;    ///< end of the last request, from the beginning of the run
  LatencyHistogram latency;
  /// delays between the intended and the actual start of requests, caused by the generator itself
  LatencyHistogram start_lag;
  std::map<absl::StatusCode, int64_t> codes;
  std::map<std::string, int64_t> errors;
  int64_t exhausted_with_retry_info = 0;     ///< RESOURCE_EXHAUSTED with a time to retry
  int64_t exhausted_without_retry_info = 0;  ///< RESOURCE_EXHAUSTED without a time to retry
  /// Durations of successful calls by step, each from the start of the call.
  std::map<std::string, LatencyHistogram> steps;
  std::array<int64_t, kTallies> tallies = {};
  std::vector<Sample> samples;  ///< first kMaxSamples requests
  int64_t samples_left_out = 0;

  /// Returns a count in addition to requests.
  int64_t tally(Tally what) const { return tallies[static_cast<size_t>(what)]; }
  /// Returns the number of successful requests.
  int64_t succeeded() const;
};

/// Collects the counts and durations of a run, from any thread.
class RunLog {
 public:
  static constexpr size_t kMaxSamples = 200'000;

  /// Counts a request that was due.
  void Arrived();
  /// Counts a request that was skipped.
  void Skipped();
  /// Records the delay of a request's start against its intended start.
  void Started(int64_t lag_ns);
  /// Records the end of a request.
  void Ended(int64_t intended_ns, int64_t end_ns, const Outcome& outcome);
  /// Records the duration of a successful call.
  void StepTook(std::string_view step, int64_t ns);
  /// Adds `number` to a count in addition to requests.
  void Add(Tally what, int64_t number = 1);

  /// Returns the record. REQUIRES: all requests have ended.
  RunRecord Take() { return std::move(record_); }

 private:
  void CountExhausted(const Outcome& outcome);

  std::mutex mutex_;
  RunRecord record_;
};

}  // namespace slicefarm::load
