#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Limits of a tenant's stored data: the number of its jobs, including ended jobs, and the bytes of
/// its blobs. The data in the stores is counted every few seconds. Until the next count, this
/// object adds the new data that this coordinator accepts. So several coordinators may together
/// exceed a limit by the data that they accept between two counts. Results count but are never
/// refused, because an accepted job must end. Thread-safe.
class TenantBudgets {
 public:
  /// Creates the limits. `now_us`: a clock that never runs backwards. The stores must outlive this
  /// object.
  TenantBudgets(JobStore& jobs, BlobStores& blobs, std::function<int64_t()> now_us)
      : jobs_(jobs), blobs_(blobs), now_us_(std::move(now_us)) {}

  /// Checks that the tenant may store `more` further jobs. `most`: limit of the tenant. Errors:
  /// DISK_LOW, with `budget`, `limit`, `got` and the time after which to retry; see JobStore.
  absl::Status CheckJobs(const std::string& tenant, int64_t most, int64_t more);
  /// Checks that the tenant may store `more` further bytes. `most`: limit of the tenant. Errors: as
  /// in CheckJobs; see BlobStore.
  absl::Status CheckBytes(const std::string& tenant, int64_t most, int64_t more);

 private:
  struct Kept {
    int64_t count = 0;
    int64_t until_us = INT64_MIN;  ///< time of the next count
  };
  using Count = std::function<absl::StatusOr<int64_t>()>;

  absl::Status Check(Kept& kept, const Count& count, const char* budget, int64_t most,
                     int64_t more);

  JobStore& jobs_;
  BlobStores& blobs_;
  const std::function<int64_t()> now_us_;
  std::mutex mutex_;
  std::map<std::string, Kept> kept_jobs_;
  std::map<std::string, Kept> kept_bytes_;
};

}  // namespace slicefarm::coordinator
