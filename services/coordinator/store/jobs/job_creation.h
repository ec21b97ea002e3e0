#pragma once

#include <map>
#include <optional>
#include <string>

#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

// Implements JobStore::Create and FindRequested in SQL.

/// Data that shows whether a call repeats an earlier call.
struct Request {
  const std::string& tenant;
  const std::string& request_id;
  const std::string& spec_digest;
};

/// Returns the job that an earlier call with the same request id created; nullopt if there was
/// none. Errors: REQUEST_ID_REUSED.
absl::StatusOr<std::optional<JobRecord>> FindEarlier(SqlConnection& db, const Request& request);

/// Inserts the labels of a job that has no labels yet. REQUIRES: a transaction.
absl::Status InsertLabels(SqlConnection& db, int64_t number,
                          const std::map<std::string, std::string>& labels);

/// Creates a job, or finds the job of an earlier call. REQUIRES: a transaction.
absl::StatusOr<Created> MakeJob(SqlConnection& db, const NewJob& job, int64_t now_us);

}  // namespace slicefarm::coordinator
