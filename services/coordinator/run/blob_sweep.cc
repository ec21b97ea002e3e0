#include "services/coordinator/run/blob_sweep.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kJobsAtOnce = 100;
constexpr size_t kBlobsAtOnce = 100;

absl::Status SweepJobs(JobStore& jobs, int64_t ended_before_us, Swept& swept) {
  while (true) {
    const auto ended = jobs.EndedBefore(ended_before_us, kJobsAtOnce);
    if (!ended.ok() || ended->empty()) return ended.status();
    for (const std::string& id : *ended) {
      const absl::Status deleted = jobs.Delete(id);
      if (!deleted.ok() && !absl::IsNotFound(deleted)) return deleted;
      ++swept.jobs;
    }
  }
}

/// Those of `idle` that nothing refers to.
absl::Status SweepIdle(JobStore& jobs, BlobStore& blobs, const std::vector<BlobEntry>& idle,
                       double idle_s, Swept& swept) {
  std::set<std::string> digests;
  for (const BlobEntry& blob : idle) digests.insert(blob.digest);
  const auto referenced = jobs.Referenced(digests);
  if (!referenced.ok()) return referenced.status();
  for (const BlobEntry& blob : idle) {
    if (referenced->contains(blob.digest)) continue;
    const auto deleted = blobs.Delete(blob.digest, idle_s);
    if (!deleted.ok()) return deleted.status();
    if (!*deleted) continue;
    ++swept.blobs;
    swept.bytes += blob.size;
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<Swept> Sweep(JobStore& jobs, BlobStore& blobs, const SweepOptions& options,
                            int64_t now_us) {
  Swept swept;
  if (options.keep_jobs_s > 0) {
    const auto kept_us = static_cast<int64_t>(options.keep_jobs_s * 1e6);
    if (absl::Status done = SweepJobs(jobs, now_us - kept_us, swept); !done.ok()) return done;
  }
  std::vector<BlobEntry> idle;
  absl::Status status = blobs.ForEach([&](const BlobEntry& blob) {
    if (blob.idle_s >= options.keep_blobs_s) idle.push_back(blob);
  });
  for (size_t first = 0; status.ok() && first < idle.size(); first += kBlobsAtOnce) {
    const auto begin = idle.begin() + static_cast<std::ptrdiff_t>(first);
    const auto count = std::min(kBlobsAtOnce, idle.size() - first);
    status = SweepIdle(jobs, blobs, {begin, begin + static_cast<std::ptrdiff_t>(count)},
                       options.keep_blobs_s, swept);
  }
  if (!status.ok()) return status;
  return swept;
}

}  // namespace slicefarm::coordinator
