// Events of MemoryJobStore.
#include <algorithm>

#include "services/coordinator/store/jobs/job_steps.h"
#include "tests/support/memory_job_store.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::vector<JobEventRecord>> MemoryJobStore::Events(const std::string& id,
                                                                   int64_t after, int32_t limit) {
  const std::lock_guard lock(jobs_.mutex_);
  const Entry* entry = Find(id);
  if (!entry) return JobNotFound(id);
  std::vector<JobEventRecord> events;
  for (const JobEventRecord& event : entry->events) {
    if (static_cast<int32_t>(events.size()) == limit) break;
    if (event.sequence > after) events.push_back(event);
  }
  return events;
}

absl::StatusOr<std::vector<TenantEvent>> MemoryJobStore::EventsOf(const std::string& tenant,
                                                                  const EventCursor& after,
                                                                  int32_t limit) {
  const std::lock_guard lock(jobs_.mutex_);
  std::vector<TenantEvent> events;
  for (const auto& [number, entry] : jobs_.entries_) {
    if (entry.job.tenant != tenant) continue;
    for (const JobEventRecord& event : entry.events) {
      const EventCursor cursor{event.time_us, number, event.sequence};
      if (cursor > after) events.push_back({entry.job.id, cursor, event});
    }
  }
  std::sort(events.begin(), events.end(),
            [](const TenantEvent& a, const TenantEvent& b) { return a.cursor < b.cursor; });
  if (std::ssize(events) > limit) events.resize(static_cast<size_t>(limit));
  return events;
}

}  // namespace slicefarm::coordinator
