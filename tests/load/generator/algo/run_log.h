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

/// How a request ended. `step`: the call that brought the error, such as "CreateJob".
struct Outcome {
  absl::Status status = {};
  std::string step = {};
  bool says_when_to_retry = false;  ///< the error carries RetryInfo
};

/// One request that ended.
struct Sample {
  int64_t intended_ns = 0;  ///< from the beginning of the run
  int64_t latency_ns = 0;   ///< from the intended start
  absl::StatusCode code = absl::StatusCode::kOk;
  std::string error;  ///< empty: none
};

enum class Tally { kRetries, kEvents, kCachedJobs, kBytesSent, kBytesReceived };
inline constexpr int kTallies = 5;

/// What happened during a run.
struct RunRecord {
  int64_t arrivals = 0;  ///< requests that were to start
  int64_t skipped = 0;   ///< of those: never started, because too many were in flight
  int64_t end_ns = 0;    ///< of the last request, from the beginning of the run
  LatencyHistogram latency;
  LatencyHistogram start_lag;  ///< how late the generator itself was
  std::map<absl::StatusCode, int64_t> codes;
  std::map<std::string, int64_t> errors;
  int64_t exhausted_with_retry_info = 0;     ///< RESOURCE_EXHAUSTED that says when to come again
  int64_t exhausted_without_retry_info = 0;  ///< ... that does not
  std::map<std::string, LatencyHistogram> steps;  ///< of calls that went well, from their own start
  std::array<int64_t, kTallies> tallies = {};
  std::vector<Sample> samples;  ///< the first kMaxSamples
  int64_t samples_left_out = 0;

  int64_t tally(Tally what) const { return tallies[static_cast<size_t>(what)]; }
  int64_t succeeded() const;
};

/// Collects what happens, from any thread.
class RunLog {
 public:
  static constexpr size_t kMaxSamples = 200'000;

  void Arrived();
  void Skipped();
  void Started(int64_t lag_ns);
  void Ended(int64_t intended_ns, int64_t end_ns, const Outcome& outcome);
  void StepTook(std::string_view step, int64_t ns);
  void Add(Tally what, int64_t number = 1);

  /// REQUIRES: all requests ended.
  RunRecord Take() { return std::move(record_); }

 private:
  void CountExhausted(const Outcome& outcome);

  std::mutex mutex_;
  RunRecord record_;
};

}  // namespace slicefarm::load
