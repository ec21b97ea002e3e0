#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// JobStore::Create and FindRequested in SQL.

/// What a call says that may have been made before.
struct Request {
  const std::string& tenant;
  const std::string& request_id;
  const std::string& spec_digest;
};

/// The job that an earlier call with the same request id made, if there was one. Errors:
/// REQUEST_ID_REUSED.
absl::StatusOr<std::optional<JobRecord>> FindEarlier(SqlConnection& db, const Request& request);

/// Those of a job that has none. In a transaction.
absl::Status InsertLabels(SqlConnection& db, int64_t number,
                          const std::map<std::string, std::string>& labels);

/// In a transaction.
absl::StatusOr<Created> MakeJob(SqlConnection& db, const NewJob& job, int64_t now_us);

}  // namespace slicefarm::coordinator
