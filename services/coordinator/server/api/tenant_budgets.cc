#include "services/coordinator/server/api/tenant_budgets.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kCountedForUs = 5'000'000;
/// Before a retry can succeed, the sweep or the tenant must remove data.
constexpr const char* kRetryMs = "60000";

}  // namespace

absl::Status TenantBudgets::CheckJobs(const std::string& tenant, int64_t most, int64_t more) {
  if (most == INT64_MAX) return absl::OkStatus();
  const std::lock_guard lock(mutex_);
  return Check(
      kept_jobs_[tenant], [&] { return jobs_.CountOf(tenant); }, "jobs", most, more);
}

absl::Status TenantBudgets::CheckBytes(const std::string& tenant, int64_t most, int64_t more) {
  if (most == INT64_MAX) return absl::OkStatus();
  const auto count = [&]() -> absl::StatusOr<int64_t> {
    const auto blobs = blobs_.Of(tenant);
    if (!blobs.ok()) return blobs.status();
    return (*blobs)->KeptBytes();
  };
  const std::lock_guard lock(mutex_);
  return Check(kept_bytes_[tenant], count, "bytes", most, more);
}

absl::Status TenantBudgets::Check(Kept& kept, const Count& count, const char* budget, int64_t most,
                                  int64_t more) {
  if (now_us_() >= kept.until_us) {
    const auto counted = count();
    if (!counted.ok()) return counted.status();
    kept = {*counted, now_us_() + kCountedForUs};
  }
  const int64_t then = kept.count + more;
  if (then <= most) {
    kept.count = then;
    return absl::OkStatus();
  }
  return MakeError(absl::StatusCode::kResourceExhausted, Reason::kDiskLow,
                   fmt::format("the tenant may store {} {}, and would have {}: delete jobs, or "
                               "wait until old jobs are removed",
                               most, budget, then),
                   {{"budget", budget},
                    {"limit", std::to_string(most)},
                    {"got", std::to_string(then)},
                    {rpc::kRetryAfterMs, kRetryMs}});
}

}  // namespace slicefarm::coordinator
