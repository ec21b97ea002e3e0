#include "services/coordinator/server/execution/job_results.h"

#include <utility>

#include "common/config/process_settings.h"

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

absl::StatusOr<JobUpdate> JobResults::Keep(const ResolvedJob& job, const RunOutput& output,
                                           const std::string& result_tenant) {
  const auto blobs = blobs_.Of(result_tenant);
  if (!blobs.ok()) return blobs.status();
  JobResult result = output.result;
  result.tenant = result_tenant;
  if (job.request.mode == JobMode::kPrint) {
    result.gcode_size = output.program.size();
    auto gcode = (*blobs)->PutText(output.program);
    if (!gcode.ok()) return gcode.status();
    result.gcode_sha256 = *std::move(gcode);
  }
  auto report = (*blobs)->Put(output.report_json);
  if (!report.ok()) return report.status();
  result.report_sha256 = *std::move(report);
  result.cost = CostOfJob(job, result);
  return Success(std::move(result));
}

absl::StatusOr<std::optional<JobRecord>> JobResults::SucceedFromCache(const Lease& lease,
                                                                      const ResolvedJob& job,
                                                                      int64_t now_us) {
  auto found = Find(job);
  if (!found.ok()) return found.status();
  if (!*found) return std::nullopt;
  JobResult result = **std::move(found);
  result.cached = true;
  result.cost = CostOfJob(job, result);
  if (job.request.mode == JobMode::kQuote) {
    result.gcode_sha256.clear();
    result.gcode_size = 0;
  }
  auto ended = jobs_.Update(lease, Success(std::move(result)), now_us);
  if (absl::IsNotFound(ended.status())) return std::nullopt;
  if (!ended.ok()) return ended.status();
  return *std::move(ended);
}

/// Returns the first stored result that serves the job and has all its blobs; nullopt if there is
/// none. Removes incomplete and unreadable results from the index.
absl::StatusOr<std::optional<JobResult>> JobResults::Find(const ResolvedJob& job) {
  for (const std::string& action : job.serving_actions) {
    auto found = jobs_.FindResult(action);
    if (!found.ok() && !absl::IsDataLoss(found.status())) return found.status();
    if (found.ok()) {
      if (!*found) continue;
      const auto complete = Complete(**found);
      if (!complete.ok()) return complete.status();
      if (*complete) return found;
    }
    if (absl::Status done = jobs_.ForgetResult(action); !done.ok()) return done;
  }
  return std::nullopt;
}

/// Returns true if all artifacts exist unchanged. An unreadable artifact counts as missing, so the
/// work is done again. Errors: the store is unavailable.
absl::StatusOr<bool> JobResults::Complete(const JobResult& result) {
  const auto blobs = blobs_.Of(result.tenant);
  if (!blobs.ok()) return blobs.status();
  for (const std::string& digest : {result.gcode_sha256, result.report_sha256}) {
    if (digest.empty()) continue;
    absl::Status opened = (*blobs)->Keep(digest).status();
    if (opened.ok()) opened = (*blobs)->Open(digest).status();
    if (absl::IsUnavailable(opened)) return opened;
    if (!opened.ok()) return false;
  }
  return true;
}

Cost JobResults::CostOfJob(const ResolvedJob& job, const JobResult& result) const {
  const JobSettings& settings = job.plate.settings;
  return CostOf(rates_, result.print_time_s, result.filament_g,
                config::SettingsOf(settings.process()).MaterialCostPerKg(settings));
}

}  // namespace slicefarm::coordinator
