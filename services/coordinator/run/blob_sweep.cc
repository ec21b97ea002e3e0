#include "services/coordinator/run/blob_sweep.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kJobsAtOnce = 100;
constexpr size_t kBlobsAtOnce = 25'000;

/// Deletes jobs that ended before `ended_before_us`. Continues after the failure to delete one job,
/// and returns the first error in the end.
absl::Status SweepJobs(JobStore& jobs, int64_t ended_before_us, const CancelToken& cancel,
                       Swept& swept) {
  absl::Status first_error;
  for (bool more = true; more;) {
    const auto ended = jobs.EndedBefore(ended_before_us, kJobsAtOnce);
    if (!ended.ok()) return ended.status();
    more = false;  // without a deletion, the same jobs would be listed again and again
    for (const std::string& id : *ended) {
      if (absl::Status go_on = cancel.Check(); !go_on.ok()) return go_on;
      const absl::Status deleted = jobs.Delete(id);
      if (absl::IsUnavailable(deleted)) return deleted;
      // Deleted by another coordinator.
      const bool gone = deleted.ok() || absl::IsNotFound(deleted);
      if (!gone) first_error.Update(deleted);
      more = more || gone;
      swept.jobs += deleted.ok();
    }
  }
  return first_error;
}

/// Deletes the blobs of `idle` to which no job of the tenant refers. Continues after the failure to
/// delete one blob, and returns the first error in the end.
absl::Status SweepIdle(JobStore& jobs, const std::string& tenant, BlobStore& blobs,
                       const std::vector<BlobEntry>& idle, double idle_s, const CancelToken& cancel,
                       Swept& swept) {
  std::set<std::string> digests;
  for (const BlobEntry& blob : idle) digests.insert(blob.digest);
  const auto referenced = jobs.Referenced(tenant, digests);
  if (!referenced.ok()) return referenced.status();
  absl::Status first_error;
  for (const BlobEntry& blob : idle) {
    if (referenced->contains(blob.digest)) continue;
    if (absl::Status go_on = cancel.Check(); !go_on.ok()) return go_on;
    const auto deleted = blobs.Delete(blob.digest, idle_s);
    if (absl::IsUnavailable(deleted.status())) return deleted.status();
    first_error.Update(deleted.status());
    if (!deleted.ok() || !*deleted) continue;
    ++swept.blobs;
    swept.bytes += blob.size;
  }
  return first_error;
}

absl::Status SweepTenant(JobStore& jobs, const std::string& tenant, BlobStore& blobs, double idle_s,
                         const CancelToken& cancel, Swept& swept) {
  std::vector<BlobEntry> idle;
  absl::Status status = blobs.ForEach([&](const BlobEntry& blob) {
    if (blob.idle_s >= idle_s) idle.push_back(blob);
  });
  for (size_t first = 0; first < idle.size(); first += kBlobsAtOnce) {
    const auto begin = idle.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(kBlobsAtOnce, idle.size() - first);
    const absl::Status swept_these =
        SweepIdle(jobs, tenant, blobs, {begin, begin + static_cast<std::ptrdiff_t>(count)}, idle_s,
                  cancel, swept);
    if (absl::IsUnavailable(swept_these) || absl::IsCancelled(swept_these)) return swept_these;
    status.Update(swept_these);
  }
  return status;
}

/// Longest interruption of a store's use that still counts as use.
constexpr int64_t kMostGapUs = int64_t{24} * 3600 * 1'000'000;

}  // namespace

absl::StatusOr<bool> HasBeenInUse(JobStore& jobs, const SweepOptions& options, int64_t now_us) {
  const auto since_us = jobs.InUseSince(now_us, kMostGapUs);
  if (!since_us.ok()) return since_us.status();
  return static_cast<double>(now_us - *since_us) >= options.min_use_s * 1e6;
}

absl::StatusOr<Swept> Sweep(JobStore& jobs, BlobStores& blobs, const SweepOptions& options,
                            int64_t now_us, const CancelToken& cancel) {
  Swept swept;
  absl::Status first_error;  // error of one job or tenant; the sweep continues
  if (options.keep_jobs_s > 0) {
    const auto kept_us = static_cast<int64_t>(options.keep_jobs_s * 1e6);
    first_error.Update(SweepJobs(jobs, now_us - kept_us, cancel, swept));
  }
  const auto tenants = blobs.Tenants();
  if (!tenants.ok()) return tenants.status();
  for (const std::string& tenant : *tenants) {
    const auto store = blobs.Of(tenant);
    first_error.Update(store.status());
    if (!store.ok()) continue;
    first_error.Update(SweepTenant(jobs, tenant, **store, options.keep_blobs_s, cancel, swept));
    const auto damaged = (*store)->DropDamaged(options.keep_damaged_s);
    first_error.Update(damaged.status());
    swept.bytes += damaged.value_or(0);
  }
  if (!first_error.ok()) return first_error;
  return swept;
}

}  // namespace slicefarm::coordinator
