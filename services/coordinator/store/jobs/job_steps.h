#pragma once

#include <string>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

// Rules that all implementations of JobStore share: the effect of a write on a record. Pure.

/// Applies an update by the job's owner. Errors: Aborted if the lease is not the job's current one,
/// or if the job has ended; Internal if the job must not change to the new state (MayFollow).
absl::Status ApplyUpdate(JobRecord& job, const Lease& lease, const JobUpdate& update,
                         int64_t now_us);

/// Applies a cancel request. Returns false if nothing changes.
bool ApplyCancel(JobRecord& job, int64_t now_us);

/// Applies the changes of a client.
void ApplyChange(JobRecord& job, const JobChanging& changing);

/// Ends the job as FAILED with `error`, because its deadline has passed. Returns false and changes
/// nothing if the job is not overdue in the sense of JobStore::EndOverdue.
bool ApplyOverdue(JobRecord& job, const JobError& error, int64_t now_us);

/// Returns the error Aborted: the lease is not the current one.
absl::Status NotHeld(const Lease& lease);
/// Returns the error JOB_NOT_FOUND.
absl::Status JobNotFound(const std::string& id);
/// Returns the error JOB_NOT_FINISHED.
absl::Status JobNotFinished(const std::string& id);
/// Returns the error BLOB_NOT_FOUND: the cached result was deleted meanwhile.
absl::Status CachedResultGone(const std::string& id);
/// Returns the error REQUEST_ID_REUSED.
absl::Status RequestIdReused(const std::string& request_id);
/// Returns the error QUEUE_FULL.
absl::Status QueueFull(int64_t limit);

}  // namespace slicefarm::coordinator
