#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore::List and Events in SQL.
absl::StatusOr<std::vector<JobRecord>> ListJobs(SqlConnection& db, const ListQuery& list);
absl::StatusOr<std::vector<JobEventRecord>> ListEvents(SqlConnection& db, const std::string& id,
                                                       int64_t after, int32_t limit);

}  // namespace slicefarm::coordinator
