#include "services/coordinator/server/observe/job_traces.h"

#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "services/coordinator/algo/job_trace.h"
#include "services/coordinator/server/observe/job_log.h"
#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator {
namespace {

/// Largest number of events of a job that are read. A job has more only if it returns to the queue
/// again and again.
constexpr int32_t kMaxEvents = 2'000;

absl::StatusOr<JobTrace> Read(const JobRecord& job, BlobStores& stores) {
  if (job.trace_sha256.empty()) return JobTrace();
  const auto blobs = stores.Of(job.tenant);
  if (!blobs.ok()) return blobs.status();
  const auto json = (*blobs)->Get(job.trace_sha256);
  if (!json.ok()) return json.status();
  return JobTraceFromJson(*json);
}

std::vector<Span> Waits(const std::vector<JobEventRecord>& events) {
  std::vector<Span> waits;
  for (size_t i = 0; i + 1 < events.size(); ++i) {
    if (events[i].state != JobState::kQueued) continue;
    waits.push_back({"queued", "", events[i].time_us, events[i + 1].time_us});
  }
  return waits;
}

std::map<std::string, std::string> About(const JobRecord& job) {
  std::map<std::string, std::string> about = {{"job", job.id},
                                              {"state", std::string(JobStateName(job.state))},
                                              {"trace_id", TraceOf(job).trace_id},
                                              {"build_id", job.build_id},
                                              {"layers", absl::StrCat(job.layers_total)}};
  if (job.result) about["cached"] = job.result->cached ? "true" : "false";
  if (job.error) about["reason"] = job.error->reason;
  return about;
}

}  // namespace

absl::StatusOr<std::string> JobTraces::Keep(const JobRecord& job, const SpanLog& run, Span whole) {
  // If the earlier trace is lost, the new one is stored nevertheless.
  JobTrace trace = Joined(Read(job, blobs_).value_or(JobTrace()), run);
  trace.spans.push_back(std::move(whole));
  const auto blobs = blobs_.Of(job.tenant);
  if (!blobs.ok()) return blobs.status();
  return (*blobs)->Put(ToJson(trace));
}

absl::StatusOr<std::string> JobTraces::Chrome(const JobRecord& job) {
  if (!IsTerminal(job.state)) return JobNotFinished(job.id);
  const auto events = jobs_.Events(job.id, 0, kMaxEvents);
  if (!events.ok()) return events.status();
  const auto trace = Read(job, blobs_);
  if (!trace.ok()) return trace.status();
  return ChromeTrace(*trace, Waits(*events), About(job));
}

}  // namespace slicefarm::coordinator
