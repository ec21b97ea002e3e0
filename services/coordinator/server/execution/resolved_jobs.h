#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/coordinator/server/messages/job_request.h"

namespace slicefarm::coordinator {

/// Cache of the last resolved jobs. So a job that is claimed again is not resolved again, and a
/// thousand jobs with the same spec are resolved only once. The number of entries is limited. Jobs
/// with large tables of settings are not cached. Thread-safe.
class ResolvedJobs {
 public:
  explicit ResolvedJobs(std::string build_id) : build_id_(std::move(build_id)) {}

  /// Returns the resolved job (ResolveJob) for `spec`, the bytes of JobRecord.spec. Errors: see
  /// ReadSpec and ResolveJob.
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> Of(const std::string& spec,
                                                        std::string_view result_tenant,
                                                        const CancelToken& cancel = {});

  /// Returns the resolved job for a spec that was already read as `request`.
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> Of(const std::string& spec,
                                                        const JobRequest& request,
                                                        std::string_view result_tenant,
                                                        const CancelToken& cancel = {});

  int64_t resolved() const;  ///< number of jobs that were not found in the cache

 private:
  struct Kept {
    std::string key;
    std::shared_ptr<const ResolvedJob> job;  // shared with its users
  };

  using Request = std::function<absl::StatusOr<JobRequest>()>;
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> FindOrResolve(const std::string& spec,
                                                                   const Request& request,
                                                                   std::string_view result_tenant,
                                                                   const CancelToken& cancel);
  std::shared_ptr<const ResolvedJob> Find(const std::string& key);
  void Keep(std::string key, std::shared_ptr<const ResolvedJob> job);

  const std::string build_id_;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  ///< the most recently used entry is first
  int64_t resolved_ = 0;
};

}  // namespace slicefarm::coordinator
