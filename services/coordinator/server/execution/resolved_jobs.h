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

/// The jobs that were resolved last, so that a job that is claimed again, or the same work asked
/// for a thousand times, is resolved once. Bounded in number; jobs with large tables of settings
/// are not kept. Thread-safe.
class ResolvedJobs {
 public:
  explicit ResolvedJobs(std::string build_id) : build_id_(std::move(build_id)) {}

  /// ResolveJob of a spec as JobRecord has it. Errors: those of ReadSpec and ResolveJob.
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> Of(const std::string& spec,
                                                        std::string_view result_tenant,
                                                        const CancelToken& cancel = {});

  /// The same where the spec was read already.
  absl::StatusOr<std::shared_ptr<const ResolvedJob>> Of(const std::string& spec,
                                                        const JobRequest& request,
                                                        std::string_view result_tenant,
                                                        const CancelToken& cancel = {});

  int64_t resolved() const;  ///< that were not found

 private:
  struct Kept {
    std::string key;
    std::shared_ptr<const ResolvedJob> job;  // shared with those who use it
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
  std::list<Kept> kept_;  ///< the one that was used last first
  int64_t resolved_ = 0;
};

}  // namespace slicefarm::coordinator
