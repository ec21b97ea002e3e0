#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Implements JobStore::List in SQL.
absl::StatusOr<std::vector<JobRecord>> ListJobs(SqlConnection& db, const ListQuery& list);
/// Implements JobStore::Events in SQL.
absl::StatusOr<std::vector<JobEventRecord>> ListEvents(SqlConnection& db, const std::string& id,
                                                       int64_t after, int32_t limit);
/// Implements JobStore::EventsOf in SQL.
absl::StatusOr<std::vector<TenantEvent>> ListEventsOf(SqlConnection& db, const std::string& tenant,
                                                      const EventCursor& after, int32_t limit);

}  // namespace slicefarm::coordinator
