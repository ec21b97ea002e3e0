#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore::List, Events and EventsOf in SQL.
absl::StatusOr<std::vector<JobRecord>> ListJobs(SqlConnection& db, const ListQuery& list);
absl::StatusOr<std::vector<JobEventRecord>> ListEvents(SqlConnection& db, const std::string& id,
                                                       int64_t after, int32_t limit);
absl::StatusOr<std::vector<TenantEvent>> ListEventsOf(SqlConnection& db, const std::string& tenant,
                                                      const EventPlace& after, int32_t limit);

}  // namespace slicefarm::coordinator
