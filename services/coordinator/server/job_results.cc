#include "services/coordinator/server/job_results.h"

#include <utility>

namespace slicefarm::coordinator {
namespace {

JobUpdate Success(JobResult result) {
  JobUpdate update;
  update.state = JobState::kSucceeded;
  update.layers_total = update.layers_done = result.layers;
  update.result = std::move(result);
  return update;
}

}  // namespace

absl::StatusOr<JobRecord> JobResults::Succeed(const Lease& lease, RunOutput output,
                                              const std::string& result_tenant, int64_t now_us) {
  const auto blobs = blobs_.Of(result_tenant);
  if (!blobs.ok()) return blobs.status();
  JobResult result = std::move(output.result);
  result.tenant = result_tenant;
  result.gcode_size = static_cast<int64_t>(output.gcode.size());
  auto gcode = (*blobs)->Put(output.gcode);
  if (!gcode.ok()) return gcode.status();
  auto report = (*blobs)->Put(output.report_json);
  if (!report.ok()) return report.status();
  result.gcode_sha256 = *std::move(gcode);
  result.report_sha256 = *std::move(report);
  return jobs_.Update(lease, Success(std::move(result)), now_us);
}

absl::StatusOr<std::optional<JobRecord>> JobResults::SucceedFromCache(
    const Lease& lease, const std::string& action_digest, int64_t now_us) {
  auto found = jobs_.FindResult(action_digest);
  if (!found.ok()) return found.status();
  if (!*found) return std::nullopt;
  const auto complete = Complete(**found);
  if (!complete.ok()) return complete.status();
  if (!*complete) {
    if (absl::Status done = jobs_.ForgetResult(action_digest); !done.ok()) return done;
    return std::nullopt;
  }
  JobResult result = **std::move(found);
  result.cached = true;
  auto job = jobs_.Update(lease, Success(std::move(result)), now_us);
  if (absl::IsNotFound(job.status())) return std::nullopt;
  if (!job.ok()) return job.status();
  return *std::move(job);
}

/// True if both artifacts are there, unchanged.
absl::StatusOr<bool> JobResults::Complete(const JobResult& result) {
  const auto blobs = blobs_.Of(result.tenant);
  if (!blobs.ok()) return blobs.status();
  for (const std::string& digest : {result.gcode_sha256, result.report_sha256}) {
    absl::Status opened = (*blobs)->Keep(digest).status();
    if (opened.ok()) opened = (*blobs)->Open(digest).status();
    if (absl::IsNotFound(opened) || absl::IsDataLoss(opened)) return false;
    if (!opened.ok()) return opened;
  }
  return true;
}

}  // namespace slicefarm::coordinator
