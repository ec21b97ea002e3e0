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
  /// Idle time after which a blob is removed if no job refers to it. Must be longer than two
  /// delays: from an upload to the creation of its job, and from the storage of a result to the
  /// update of the job's record.
  double keep_blobs_s = 24 * 3600;
  /// Time for which a store must have been in use before anything is removed from it.
  double min_use_s = 24 * 3600;
  /// Time after which damaged blobs are removed. Before, a person can inspect them.
  double keep_damaged_s = 7 * 24 * 3600;
};

/// Returns true if the store has been in use for SweepOptions::min_use_s, and records the current
/// use. A store must wait for that long if it is new, was restored, or was out of use for more than
/// a day. The coordinator may be connected to the wrong database then, and blobs that this database
/// does not contain may belong to the right one. Errors: see JobStore.
absl::StatusOr<bool> HasBeenInUse(JobStore& jobs, const SweepOptions& options, int64_t now_us);

/// Counts of removed jobs, blobs and bytes.
struct Swept {
  int64_t jobs = 0;
  int64_t blobs = 0;
  int64_t bytes = 0;
};

/// Removes unused data: jobs that ended long ago, blobs that are neither input nor result of a job,
/// and abandoned uploads. Other coordinators may use a blob at any moment: they mark it as used
/// (BlobStore::Keep) before they refer to it, and the sweep spares blobs that were used recently.
/// If one item cannot be removed, the sweep continues. Errors: the first error of `jobs` or
/// `blobs`; CANCELLED.
absl::StatusOr<Swept> Sweep(JobStore& jobs, BlobStores& blobs, const SweepOptions& options,
                            int64_t now_us, const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
