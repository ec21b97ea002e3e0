#pragma once

#include <cstdint>

#include "common/base/cancel_token.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

struct SweepOptions {
  /// Ended jobs are removed after so long; 0: never.
  double keep_jobs_s = 0;
  /// Blobs that no job refers to are removed if they were not used for so long: longer than from an
  /// upload to its job, and from a result to its record.
  double keep_blobs_s = 24 * 3600;
  double settle_s = 24 * 3600;  ///< time in use before anything is removed
  /// Damaged blobs that were put aside, for somebody to look at.
  double keep_damaged_s = 7 * 24 * 3600;
};

/// Returns true if the store has been in use for SweepOptions::settle_s, and notes that it is in
/// use now. A store that is new, was restored, or was out of use for more than a day is left alone
/// for that long: its database may be the wrong one, and the blobs that it does not know may belong
/// to the right one. Errors: the store's.
absl::StatusOr<bool> IsSettled(JobStore& jobs, const SweepOptions& options, int64_t now_us);

struct Swept {
  int64_t jobs = 0;
  int64_t blobs = 0;
  int64_t bytes = 0;
};

/// Removes what nobody needs any more: jobs that ended long ago; blobs that are no input and no
/// result of a job; uploads that were given up. Safe beside other coordinators, which may use a
/// blob at any moment: using it comes before referring to it, and keeps it. What cannot be removed
/// keeps nothing else. Errors: the stores', the first one; CANCELLED.
absl::StatusOr<Swept> Sweep(JobStore& jobs, BlobStores& blobs, const SweepOptions& options,
                            int64_t now_us, const CancelToken& cancel = {});

}  // namespace slicefarm::coordinator
