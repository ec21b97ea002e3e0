#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "services/coordinator/algo/job_state.h"
#include "services/coordinator/algo/pipeline/cost.h"

namespace slicefarm::coordinator {

/// Why a job failed, in a form that can be kept.
struct JobError {
  absl::StatusCode code = absl::StatusCode::kInternal;
  std::string reason;
  std::string message;
  std::map<std::string, std::string> metadata;

  friend bool operator==(const JobError&, const JobError&) = default;
};

JobError JobErrorOf(const absl::Status& status);

/// What a job came to: the names of its artifacts, and what lists show of them.
struct JobResult {
  std::string tenant;        ///< whose blobs the artifacts are
  std::string gcode_sha256;  ///< empty: of a quote
  int64_t gcode_size = 0;
  std::string report_sha256;
  double print_time_s = 0;
  double filament_mm = 0;
  double filament_g = 0;
  int32_t layers = 0;
  bool cached = false;  ///< found by content, not computed for this job
  Cost cost;            ///< by the rates when the job ended
  std::vector<std::string> warnings;

  friend bool operator==(const JobResult&, const JobResult&) = default;
};

/// What a job is to a build.
struct JobIdentity {
  std::string settings_digest;
  std::string action_digest;  ///< equal digests: equal results
  std::string build_id;
};

/// Who is served first, among the jobs of a tenant.
enum class Priority { kBulk = 0, kNormal = 1, kInteractive = 2 };

/// A deadline of jobs that have none.
inline constexpr int64_t kNoDeadlineUs = INT64_MAX;

/// A job as the store has it. Times are microseconds since 1970 on the clock of the caller; 0: not
/// yet.
struct JobRecord {
  int64_t number = 0;  ///< counts up in the order of creation
  std::string id;
  std::string tenant;
  JobState state = JobState::kQueued;
  Priority priority = Priority::kNormal;
  int64_t deadline_us = kNoDeadlineUs;  ///< what has not ended by then is of no use
  std::string spec;                     ///< opaque to the store
  std::map<std::string, std::string> labels;
  std::string settings_digest;
  std::string action_digest;  ///< equal digests: equal results
  std::string build_id;
  std::string traceparent;  ///< of the call that made it (W3C Trace Context); may be empty
  int64_t create_us = 0;
  int64_t start_us = 0;
  int64_t end_us = 0;
  int32_t layers_total = 0;
  int32_t layers_done = 0;
  std::optional<JobError> error;    ///< of FAILED
  std::optional<JobResult> result;  ///< of SUCCEEDED
  bool cancel_requested = false;
  int32_t retries = 0;         ///< how often a run failed and it was put back
  int32_t store_failures = 0;  ///< how often a store failed and it was put back
  int32_t lost_runs = 0;       ///< runs, by the present build, that began and came to no end
  int32_t deadly_runs = 0;     ///< runs, by the present build, that services died of, as it seems
  int64_t last_sequence = 0;
  std::string trace_sha256;  ///< what its runs did, and when (JobTrace); empty: not kept

  std::string owner;        ///< the coordinator that works on it
  int64_t owner_epoch = 0;  ///< counts claims: a write with an older one is refused
  int64_t owner_until_us = 0;

  friend bool operator==(const JobRecord&, const JobRecord&) = default;
};

/// One step in the life of a job, numbered from 1.
struct JobEventRecord {
  int64_t sequence = 0;
  int64_t time_us = 0;
  JobState state = JobState::kQueued;
  int32_t layers_total = 0;
  int32_t layers_done = 0;

  friend bool operator==(const JobEventRecord&, const JobEventRecord&) = default;
};

/// Errors, results, labels as JSON text, as the tables keep them. The readers take what the writers
/// wrote; anything else is DATA_LOSS.
std::string ToJson(const JobError& error);
std::string ToJson(const JobResult& result);
std::string ToJson(const std::map<std::string, std::string>& labels);
absl::Status FromJson(const std::string& json, JobError& error);
absl::Status FromJson(const std::string& json, JobResult& result);
absl::Status FromJson(const std::string& json, std::map<std::string, std::string>& labels);

}  // namespace slicefarm::coordinator
