#pragma once

#include <cstdint>

#include "common/base/cancel_token.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Storage times of jobs and blobs.
struct SweepOptions {
  /// Time after which ended jobs are removed; 0: never.
  double keep_jobs_s = 0;
  /// Idle time after which blobs without a referring job are removed. It must exceed the time from
  /// an upload to its job, and from a result to its record.
  double keep_blobs_s = 24 * 3600;
  /// Time for which a store must be in use before anything is removed.
  double settle_s = 24 * 3600;
  /// Time after which damaged blobs are removed. Until then a person can inspect them.
  double keep_damaged_s = 7 * 24 * 3600;
};

/// Returns true if the store has been in use for SweepOptions::settle_s, and records the current
/// use. The sweep ignores a store for that long if it is new, was restored, or was out of use for
/// more than a day. Such a store may have the wrong database, and the unknown blobs may belong to
/// the right one. Errors: errors of the store.
absl::StatusOr<bool> IsSettled(JobStore& jobs, const SweepOptions& options, int64_t now_us);

/// Counts of removed jobs, blobs and bytes.
struct Swept {
  int64_t jobs = 0;
  int64_t blobs = 0;
  int64_t bytes = 0;
};

/// Removes unused data: jobs that ended long ago, blobs that are neither input nor result of a job,
/// and abandoned uploads. Safe beside other coordinators, which may use a blob at any moment. A
/// coordinator uses a blob before it refers to it, and the use protects the blob. A failure to
/// remove one item does not stop the rest. Errors: the first error of the stores; CANCELLED.
absl::StatusOr<Swept> Sweep(JobStore& jobs, BlobStores& blobs, const SweepOptions& options,
                            int64_t now_us, const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
