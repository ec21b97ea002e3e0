#include "services/coordinator/server/api/job_intake.h"

#include <fmt/core.h>
#include <openssl/rand.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::coordinator {

std::string NewJobId() {
  std::array<unsigned char, 16> bytes;
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) std::abort();
  std::string id;
  for (const unsigned char byte : bytes) id += fmt::format("{:02x}", byte);
  return id;
}

absl::StatusOr<std::shared_ptr<const ResolvedJob>> JobIntake::Check(const Submission& submission,
                                                                    const CancelToken& cancel) {
  const auto spec_bytes = static_cast<int64_t>(submission.spec.size());
  if (spec_bytes > limits::kMaxSpecBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a spec", limits::kMaxSpecBytes,
                      spec_bytes);
  }
  if (absl::Status ok = CheckLabels(submission.labels); !ok.ok()) return ok;
  if (!processes_.Has(submission.request.process)) {
    const std::string_view process = ProcessName(submission.request.process);
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kProcessUnavailable,
                     fmt::format("this farm does not run jobs of process {}", process),
                     {{"process", std::string(process)}});
  }
  auto resolved = resolved_.Of(submission.spec, submission.request,
                               ResultTenant(sharing_, submission.tenant), cancel);
  if (!resolved.ok()) return resolved.status();
  if (absl::Status ok = CheckAcceptable(**resolved); !ok.ok()) return ok;
  if (absl::Status ok = CheckMeshes(submission.tenant, **resolved); !ok.ok()) return ok;
  return resolved;
}

absl::StatusOr<NewJob> JobIntake::NewJobOf(Submission submission, const CancelToken& cancel) {
  NewJob job;
  job.refusal = disk_.CheckSpace();
  job.refusal.Update(budgets_.CheckBytes(submission.tenant, submission.max_kept_bytes, 0));
  if (job.refusal.ok())
    job.refusal = budgets_.CheckJobs(submission.tenant, submission.max_kept_jobs, 1);
  const auto resolved = Check(submission, cancel);
  job.refusal.Update(resolved.status());
  // If the store is unavailable, it is not called a second time, because the caller has already
  // waited for it once.
  if (absl::IsUnavailable(job.refusal)) return job.refusal;
  // A repeated call gets its job, even if there is no space any more or a mesh is missing.
  if (!job.refusal.ok() && submission.request_id.empty()) return job.refusal;
  job.id = NewJobId();
  job.tenant = std::move(submission.tenant);
  job.request_id = std::move(submission.request_id);
  job.spec_digest = std::move(submission.spec_digest);
  job.spec = std::move(submission.spec);
  job.labels = std::move(submission.labels);
  job.priority = submission.priority;
  job.deadline_us = submission.deadline_us;
  job.webhook_url = std::move(submission.webhook_url);
  job.traceparent = Traceparent(submission.trace.empty() ? TraceOfJob(job.id) : submission.trace);
  job.max_open = submission.max_open_jobs;
  job.build_id = build_id_;
  if (resolved.ok()) {
    for (const StoredMesh& mesh : (*resolved)->request.scene.meshes)
      job.inputs.push_back(mesh.sha256);
    job.settings_digest = (*resolved)->settings_digest;
    job.action_digest = (*resolved)->action_digest;
  }
  return job;
}

/// Returns the job that an earlier call created, or `refusal`. Does not wait for a turn to write.
absl::StatusOr<Created> JobIntake::EarlierOr(const Submission& submission,
                                             const absl::Status& refusal) {
  if (submission.request_id.empty()) return refusal;
  auto earlier = FindAll(submission.tenant, {submission.request_id}, submission.spec_digest);
  if (!earlier.ok()) return earlier.status();
  if (earlier->empty()) return refusal;
  return Created{std::move(earlier->front()), /*fresh=*/false};
}

absl::StatusOr<Created> JobIntake::Create(Submission submission, const CancelToken& cancel) {
  // Without this check, refused calls of one tenant would delay the writes of all others.
  if (absl::Status full = full_queues_.Check(submission.tenant); !full.ok())
    return EarlierOr(submission, full);
  const auto job = NewJobOf(std::move(submission), cancel);
  if (!job.ok()) return job.status();
  const auto slot = write_slots_.Enter(job->tenant, cancel);
  if (!slot.ok()) return slot.status();
  if (absl::Status full = full_queues_.Check(job->tenant); !full.ok() && job->request_id.empty())
    return full;  // the queue became full meanwhile
  auto created = jobs_.Create(*job, now_us_());
  full_queues_.Note(job->tenant, created.status(), job->max_open);
  return created;
}

absl::StatusOr<std::vector<Created>> JobIntake::CreateAll(std::vector<Submission> submissions,
                                                          const CancelToken& cancel) {
  if (!submissions.empty()) {
    if (absl::Status full = full_queues_.Check(submissions.front().tenant); !full.ok()) return full;
  }
  std::vector<NewJob> jobs;
  for (Submission& submission : submissions) {
    auto job = NewJobOf(std::move(submission), cancel);
    if (!job.ok()) return job.status();
    jobs.push_back(*std::move(job));
  }
  const auto slot = write_slots_.Enter(jobs.empty() ? "" : jobs.front().tenant, cancel);
  if (!slot.ok()) return slot.status();
  auto created = jobs_.CreateAll(jobs, now_us_());
  if (!jobs.empty())
    full_queues_.Note(jobs.front().tenant, created.status(), jobs.front().max_open);
  return created;
}

absl::Status JobIntake::CheckMeshes(const std::string& tenant, const ResolvedJob& job) {
  const auto blobs = blobs_.Of(tenant);
  if (!blobs.ok()) return blobs.status();
  int64_t bytes = 0;
  for (const StoredMesh& mesh : job.request.scene.meshes) {
    const auto status = (*blobs)->Keep(mesh.sha256);
    if (!status.ok()) return status.status();
    if (!status->complete) {
      return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kBlobNotFound,
                       fmt::format("mesh {} was not uploaded", mesh.sha256),
                       {{"sha256", mesh.sha256}});
    }
    bytes += status->committed_size;
  }
  if (bytes <= limits::kMaxMeshBytes) return absl::OkStatus();
  return LimitError(Reason::kMeshTooLarge, "bytes of a job's meshes", limits::kMaxMeshBytes, bytes);
}

}  // namespace slicefarm::coordinator
