#include "services/coordinator/server/execution/resolved_jobs.h"

#include <algorithm>

#include "common/base/sha256.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

constexpr size_t kMostKept = 32;
/// Largest number of rows in the tables of a cached job. Larger tables may take megabytes each.
constexpr int64_t kMostRows = 32;

}  // namespace

absl::StatusOr<std::shared_ptr<const ResolvedJob>> ResolvedJobs::Of(const std::string& spec,
                                                                    std::string_view result_tenant,
                                                                    const CancelToken& cancel) {
  return FindOrResolve(
      spec, [&] { return ReadSpec(spec); }, result_tenant, cancel);
}

absl::StatusOr<std::shared_ptr<const ResolvedJob>> ResolvedJobs::Of(const std::string& spec,
                                                                    const JobRequest& request,
                                                                    std::string_view result_tenant,
                                                                    const CancelToken& cancel) {
  return FindOrResolve(
      spec, [&] { return request; }, result_tenant, cancel);
}

absl::StatusOr<std::shared_ptr<const ResolvedJob>> ResolvedJobs::FindOrResolve(
    const std::string& spec, const Request& read, std::string_view result_tenant,
    const CancelToken& cancel) {
  std::string key = Sha256Hex(spec) + std::string(result_tenant);
  if (auto found = Find(key)) return found;
  auto request = read();
  if (!request.ok()) return request.status();
  auto resolved = ResolveJob(*std::move(request), build_id_, result_tenant, cancel);
  if (!resolved.ok()) return resolved.status();
  const auto job = std::make_shared<const ResolvedJob>(*std::move(resolved));
  Keep(std::move(key), job);
  return job;
}

int64_t ResolvedJobs::resolved() const {
  const std::lock_guard lock(mutex_);
  return resolved_;
}

std::shared_ptr<const ResolvedJob> ResolvedJobs::Find(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(kept_, key, &Kept::key);
  if (found == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, found);
  return kept_.front().job;
}

void ResolvedJobs::Keep(std::string key, std::shared_ptr<const ResolvedJob> job) {
  const std::lock_guard lock(mutex_);
  ++resolved_;
  if (job->plate.region_rows > kMostRows) return;
  kept_.push_front({std::move(key), std::move(job)});
  if (kept_.size() > kMostKept) kept_.pop_back();
}

}  // namespace slicefarm::coordinator
