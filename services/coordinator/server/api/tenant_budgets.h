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

/// What a tenant may keep: the number of its jobs, ended ones among them, and the bytes of its
/// blobs. What is there is counted by the stores every few seconds, and by this process in between;
/// so several coordinators may let a tenant have as much more as they take in meanwhile. Results
/// count, and are never refused: a job that was taken ends. Thread-safe.
class TenantBudgets {
 public:
  /// `now_us`: of a clock that never runs backwards. The stores outlive it.
  TenantBudgets(JobStore& jobs, BlobStores& blobs, std::function<int64_t()> now_us)
      : jobs_(jobs), blobs_(blobs), now_us_(std::move(now_us)) {}

  /// For so many jobs more. Errors: DISK_LOW, with `budget`, `limit`, `got` and the time after
  /// which to try again; those of the stores.
  absl::Status CheckJobs(const std::string& tenant, int64_t most, int64_t more);
  /// For so many bytes more.
  absl::Status CheckBytes(const std::string& tenant, int64_t most, int64_t more);

 private:
  struct Kept {
    int64_t count = 0;
    int64_t until_us = INT64_MIN;  ///< then it is counted again
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
