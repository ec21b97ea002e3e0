#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/span_log.h"

namespace slicefarm::coordinator {

/// Of one job, over all its runs: some hundreds of KiB.
inline constexpr size_t kMaxJobSpans = 4096;

/// What was done for a job, and when, over all runs that came to an end.
struct JobTrace {
  std::vector<Span> spans;
  int64_t dropped = 0;  ///< that did not fit

  friend bool operator==(const JobTrace&, const JobTrace&) = default;
};

/// What earlier runs and this one did. Of more than kMaxJobSpans the latest are kept.
JobTrace Joined(JobTrace earlier, const SpanLog& run);

/// As it is kept: JSON text.
std::string ToJson(const JobTrace& trace);
/// Errors: DATA_LOSS.
absl::StatusOr<JobTrace> JobTraceFromJson(const std::string& json);

/// The trace in Chrome's trace event format, for Perfetto (https://ui.perfetto.dev) and
/// chrome://tracing. The job's own spans stand in one row, nested; those of each other track are
/// a process of their own, with as many rows as there were at once. Of several spans of the same
/// name on other tracks, each is told which attempt it was, and whether another one was at work
/// when it began (`copy`).
///
/// `waits`: when the job stood in the queue. `about`: what stands beside the spans.
/// Source: "Trace Event Format", Google.
std::string ChromeTrace(const JobTrace& trace, const std::vector<Span>& waits,
                        const std::map<std::string, std::string>& about);

}  // namespace slicefarm::coordinator
