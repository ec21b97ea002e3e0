#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/span_log.h"

namespace slicefarm::coordinator {

/// Largest number of spans of one job over all its runs. They take a few hundred KiB.
inline constexpr size_t kMaxJobSpans = 4096;

/// Spans of all finished runs of a job.
struct JobTrace {
  std::vector<Span> spans;
  /// Number of spans that were dropped, because a job may have at most kMaxJobSpans.
  int64_t dropped = 0;

  friend bool operator==(const JobTrace&, const JobTrace&) = default;
};

/// Returns the spans of the earlier runs and of this run. If there are more than kMaxJobSpans,
/// keeps the latest.
JobTrace Joined(JobTrace earlier, const SpanLog& run);

/// Returns the trace as the JSON text that is stored.
std::string ToJson(const JobTrace& trace);
/// Returns the trace from its stored JSON text. Errors: DATA_LOSS.
absl::StatusOr<JobTrace> JobTraceFromJson(const std::string& json);

/// Returns the trace in Chrome's trace event format, for Perfetto (https://ui.perfetto.dev) and
/// chrome://tracing. The job's own spans are nested in one row. Each other track of the trace
/// becomes a process of the format, with as many rows as there are simultaneous spans. Spans of the
/// same name on these tracks are attempts at the same work: each span gets its attempt number. It
/// also gets `copy` if another attempt was running when it began.
///
/// `waits`: periods in which the job was in the queue. `about`: additional facts about the job.
/// Source: "Trace Event Format", Google.
std::string ChromeTrace(const JobTrace& trace, const std::vector<Span>& waits,
                        const std::map<std::string, std::string>& about);

}  // namespace slicefarm::coordinator
