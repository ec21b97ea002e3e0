#pragma once

#include <string>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// The rules of JobStore that do not depend on where jobs are kept: what a write does to a record.
/// Pure.

/// Errors: Aborted if the lease is not the job's present one, or the job has ended; Internal if the
/// state may not follow.
absl::Status ApplyUpdate(JobRecord& job, const Lease& lease, const JobUpdate& update,
                         int64_t now_us);

/// False: nothing is to be done.
bool ApplyCancel(JobRecord& job, int64_t now_us);

void ApplyChange(JobRecord& job, const JobChanging& changing);

/// False: it is not one that JobStore::EndOverdue ends.
bool ApplyOverdue(JobRecord& job, const JobError& error, int64_t now_us);

absl::Status NotHeld(const Lease& lease);
absl::Status JobNotFound(const std::string& id);
absl::Status JobNotFinished(const std::string& id);
absl::Status CachedResultGone(const std::string& id);
absl::Status RequestIdReused(const std::string& request_id);
absl::Status QueueFull(int64_t limit);

}  // namespace slicefarm::coordinator
