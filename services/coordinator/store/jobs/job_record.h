#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "services/coordinator/algo/job_state.h"
#include "services/coordinator/algo/pipeline/cost.h"
#include "services/coordinator/algo/pipeline/print_shares.h"

namespace slicefarm::coordinator {

/// Error of a failed job, in a form that can be stored.
struct JobError {
  absl::StatusCode code = absl::StatusCode::kInternal;
  std::string reason;
  std::string message;
  std::map<std::string, std::string> metadata;

  friend bool operator==(const JobError&, const JobError&) = default;
};

/// Converts an error to its stored form.
JobError JobErrorOf(const absl::Status& status);

/// Result of a job: the names of its artifacts, and the values that lists show.
struct JobResult {
  std::string tenant;        ///< tenant that stores the artifacts as blobs
  std::string gcode_sha256;  ///< digest of the G-code; empty for a quote, which has no G-code
  int64_t gcode_size = 0;
  std::string report_sha256;
  double print_time_s = 0;
  double filament_mm = 0;
  double filament_mm3 = 0;
  double filament_g = 0;
  int32_t layers = 0;
  /// True if the result was taken from the store and not computed for this job.
  bool cached = false;
  Cost cost;           ///< cost by the rates at the end of the job
  PrintShares shares;  ///< time and filament by copy; empty in results of older versions
  std::vector<std::string> warnings;

  friend bool operator==(const JobResult&, const JobResult&) = default;
};

/// Digests of a job, as one build computes them.
struct JobIdentity {
  std::string settings_digest;
  std::string action_digest;  ///< two jobs with equal digests have equal results
  std::string build_id;
};

/// Order in which the jobs of a tenant are claimed.
enum class Priority { kBulk = 0, kNormal = 1, kInteractive = 2 };

/// Deadline of jobs without one.
inline constexpr int64_t kNoDeadlineUs = INT64_MAX;

/// Record of a job in the store. Times are microseconds since 1970 on the clock of the caller; 0:
/// the event has not happened yet.
struct JobRecord {
  int64_t number = 0;  ///< unique number, increasing in the order of creation
  std::string id;
  std::string tenant;
  JobState state = JobState::kQueued;
  Priority priority = Priority::kNormal;
  int64_t deadline_us = kNoDeadlineUs;  ///< time at which the job fails if it has not ended
  std::string spec;                     ///< opaque to the store
  std::map<std::string, std::string> labels;
  std::string settings_digest;
  std::string action_digest;  ///< two jobs with equal digests have equal results
  std::string build_id;
  /// Trace context of the call that created the job (W3C Trace Context); may be empty.
  std::string traceparent;
  int64_t create_us = 0;
  int64_t start_us = 0;
  int64_t end_us = 0;
  int32_t layers_total = 0;
  int32_t layers_done = 0;
  std::optional<JobError> error;    ///< error of a FAILED job
  std::optional<JobResult> result;  ///< result of a SUCCEEDED job
  bool cancel_requested = false;
  int32_t retries = 0;  ///< number of returns to the queue after a failed run
  /// Number of returns to the queue after a failure of a store.
  int32_t store_failures = 0;
  int32_t lost_runs = 0;    ///< runs by the present build that began but never ended
  int32_t deadly_runs = 0;  ///< runs by the present build that probably killed services
  int64_t last_sequence = 0;
  /// Digest of the blob with the trace of the job's runs (JobTrace); empty: there is none.
  std::string trace_sha256;

  /// Name of the coordinator that claimed the job last; empty: the job was released.
  std::string owner;
  /// Number of claims of the job; a write with a lease of an earlier claim is refused.
  int64_t owner_epoch = 0;
  int64_t owner_until_us = 0;

  friend bool operator==(const JobRecord&, const JobRecord&) = default;
};

/// Event of a job. The events of a job are numbered from 1.
struct JobEventRecord {
  int64_t sequence = 0;
  int64_t time_us = 0;
  JobState state = JobState::kQueued;
  int32_t layers_total = 0;
  int32_t layers_done = 0;

  friend bool operator==(const JobEventRecord&, const JobEventRecord&) = default;
};

/// Returns the JSON text of an error, as stored in the tables. FromJson reads only texts of ToJson;
/// for any other text it returns DATA_LOSS.
std::string ToJson(const JobError& error);
/// Returns the JSON text of a result.
std::string ToJson(const JobResult& result);
/// Returns the JSON text of labels.
std::string ToJson(const std::map<std::string, std::string>& labels);
/// Reads an error from its JSON text. Errors: DATA_LOSS.
absl::Status FromJson(const std::string& json, JobError& error);
/// Reads a result from its JSON text. Errors: DATA_LOSS.
absl::Status FromJson(const std::string& json, JobResult& result);
/// Reads labels from their JSON text. Errors: DATA_LOSS.
absl::Status FromJson(const std::string& json, std::map<std::string, std::string>& labels);

}  // namespace slicefarm::coordinator
