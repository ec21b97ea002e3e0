#include "services/coordinator/server/api/jobs_service.h"

#include <utility>

#include "common/base/cancel_scope.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/config/process_settings.h"
#include "common/model/limits.h"
#include "common/rpc/observe/trace_metadata.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/algo/pipeline/preflight.h"
#include "services/coordinator/server/api/artifact.h"
#include "services/coordinator/server/api/blob_download.h"
#include "services/coordinator/server/api/derived_artifacts.h"
#include "services/coordinator/server/api/farm_facts.h"
#include "services/coordinator/server/api/job_watch.h"
#include "services/coordinator/server/api/plate_submissions.h"
#include "services/coordinator/server/api/preset_settings.h"
#include "services/coordinator/server/api/profile_settings.h"
#include "services/coordinator/server/execution/job_meshes.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/server/observe/job_log.h"
#include "services/coordinator/server/observe/job_traces.h"
#include "services/coordinator/store/blobs/checking_reader.h"
#include "services/coordinator/store/jobs/job_steps.h"

namespace slicefarm::coordinator {
namespace {

/// Largest size of a batch's answer. Its jobs have no settings. The size is less than gRPC's limit
/// for a message.
constexpr int64_t kMaxEchoedBytes = 2 << 20;

int64_t EchoedBytes(const v1::BatchCreateJobsRequest& batch) {
  auto bytes = static_cast<int64_t>(batch.ByteSizeLong());
  for (const v1::CreateJobRequest& each : batch.requests()) {
    v1::JobSpec echoed = each.spec();
    bytes -= static_cast<int64_t>(echoed.ByteSizeLong());
    ClearSettings(echoed);
    bytes += static_cast<int64_t>(echoed.ByteSizeLong());
  }
  return bytes;
}

absl::StatusOr<std::vector<v1::Job>> ToProtos(const absl::StatusOr<std::vector<JobRecord>>& jobs) {
  if (!jobs.ok()) return jobs.status();
  std::vector<v1::Job> protos;
  for (const JobRecord& job : *jobs) protos.push_back(ToProto(job));
  return protos;
}

/// Reader of a text that was made on request.
class TextReader : public BlobReader {
 public:
  explicit TextReader(std::string text) : text_(std::move(text)) {}
  int64_t size() const override { return std::ssize(text_); }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override {
    return text_.substr(offset, count);
  }

  const std::string text_;
};

Claimant ClaimantOf(const Submission& submission) {
  return {submission.tenant, static_cast<int>(submission.priority)};
}

}  // namespace

/// Returns the job, if the caller may see it.
absl::StatusOr<JobRecord> JobsService::Find(const Caller& caller, const std::string& id, Of of) {
  auto job = backend_.jobs.Get(id);
  const bool all = of == Of::kAllForAdmins && caller.may(Scope::kAdmin);
  if (all || (!job.ok() && !absl::IsDataLoss(job.status()))) return job;
  const auto tenant =
      job.ok() ? absl::StatusOr<std::string>(job->tenant) : backend_.jobs.TenantOf(id);
  if (!tenant.ok()) return tenant.status();
  return *tenant == caller.tenant ? job : JobNotFound(id);
}

absl::StatusOr<JobRecord> JobsService::Find(const grpc::ServerContextBase& context,
                                            const Scopes& one_of, const std::string& id, Of of) {
  const auto caller = backend_.callers.Find(context, one_of);
  if (!caller.ok()) return caller.status();
  return Find(*caller, id, of);
}

grpc::Status JobsService::CreateJob(grpc::ServerContext* context,
                                    const v1::CreateJobRequest* request, v1::Job* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->validate_only()) {
    return Preflight(*context, *caller, "CreateJob", [&](const rpc::Call& call) {
      const auto submission = Read(*caller, *request);
      if (!submission.ok()) return submission.status();
      auto job = Validate(*submission, *request, call);
      if (job.ok()) *response = *std::move(job);
      return job.status();
    });
  }
  const auto created = Create(*caller, *request, *context);
  if (created.ok()) *response = ToProto(*created);
  DescribeWaiting(backend_.pipeline.executor(), backend_.away_stages, *response);
  return rpc::ToGrpc(created.status());
}

grpc::Status JobsService::BatchCreateJobs(grpc::ServerContext* context,
                                          const v1::BatchCreateJobsRequest* request,
                                          v1::BatchCreateJobsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->requests_size() > limits::kMaxBatchJobs) {
    return rpc::ToGrpc(LimitError(Reason::kRequestTooLarge, "jobs of a batch",
                                  limits::kMaxBatchJobs, request->requests_size()));
  }
  if (const int64_t bytes = EchoedBytes(*request); bytes > kMaxEchoedBytes) {
    return rpc::ToGrpc(LimitError(Reason::kRequestTooLarge, "bytes of a batch without its settings",
                                  kMaxEchoedBytes, bytes));
  }
  for (const v1::CreateJobRequest& each : request->requests()) {
    const auto created =
        each.validate_only()
            ? absl::StatusOr<JobRecord>(Malformed("validate_only", "cannot be set in batches"))
            : Create(*caller, each, *context);
    v1::BatchCreateJobsResponse::Outcome& outcome = *response->add_outcomes();
    if (created.ok()) {
      *outcome.mutable_job() = ToProto(*created);
      DescribeWaiting(backend_.pipeline.executor(), backend_.away_stages, *outcome.mutable_job());
      ClearSettings(*outcome.mutable_job()->mutable_spec());
    } else {
      // The error is shortened like the errors of calls, because one answer may contain many
      // errors.
      const absl::Status cut = rpc::FromGrpc(rpc::ToGrpc(created.status()));
      *outcome.mutable_error() = ToProto(JobErrorOf(cut));
    }
  }
  return grpc::Status::OK;
}

grpc::Status JobsService::CreatePlates(grpc::ServerContext* context,
                                       const v1::CreatePlatesRequest* request,
                                       v1::CreatePlatesResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return Preflight(*context, *caller, "CreatePlates", [&](const rpc::Call& call) {
    auto jobs = MakePlates(*caller, *request, call);
    if (!jobs.ok()) return jobs.status();
    for (v1::Job& job : *jobs) {
      KeepWhatIsOnThePlate(*job.mutable_spec());
      job.clear_labels();  // all jobs must fit into one message
      *response->add_jobs() = std::move(job);
    }
    return absl::OkStatus();
  });
}

/// Does work that takes as long as slicing, after a wait for a slot of the tenant.
grpc::Status JobsService::Preflight(
    const grpc::ServerContext& context, const Caller& caller, std::string_view method,
    const std::function<absl::Status(const rpc::Call& call)>& work) {
  const auto slot = preflights_of_tenants_.Enter(caller.tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  return preflights_.Run(context, method, [&](const rpc::Call& call) {
    const CancelScope scope(call.cancel);
    const auto work_slot = preflight_slots_.Enter(caller.tenant, call.cancel);
    return work_slot.ok() ? work(call) : work_slot.status();
  });
}

absl::StatusOr<std::vector<v1::Job>> JobsService::MakePlates(const Caller& caller,
                                                             const v1::CreatePlatesRequest& request,
                                                             const rpc::Call& call) {
  if (absl::Status ok = CheckPlates(request); !ok.ok()) return ok;
  const std::string digest = SpecDigest(request);
  if (!request.validate_only() && !request.request_id().empty()) {
    const auto earlier =
        backend_.intake.FindAll(caller.tenant, PlateRequestIds(request.request_id()), digest);
    if (!earlier.ok() || !earlier->empty()) return ToProtos(earlier);
  }
  auto plates = ReadPlates(caller, request, call);
  if (!plates.ok()) return plates.status();
  if (request.validate_only()) return ValidateAll(*plates, request, call);
  std::vector<Submission> jobs;
  for (Plate& plate : *plates) {
    plate.submission.spec_digest = digest;
    jobs.push_back(std::move(plate.submission));
  }
  if (absl::Status rate = backend_.callers.CheckJobs(caller, std::ssize(jobs)); !rate.ok())
    return rate;
  return ToProtos(CreateAll(std::move(jobs), call.cancel));
}

/// Returns a submission for each bed of each request. Counts all beds before it copies a submission
/// for each bed.
absl::StatusOr<std::vector<Plate>> JobsService::ReadPlates(const Caller& caller,
                                                           const v1::CreatePlatesRequest& request,
                                                           const rpc::Call& call) {
  const PlatesBackend backend = {backend_.intake, backend_.blobs, backend_.arranging,
                                 backend_.memory};
  PlateRequests requests(request.request_id());
  for (int i = 0; i < request.requests_size(); ++i) {
    auto submission = Read(caller, request.requests(i));
    if (!submission.ok()) return Within("requests", i, submission.status());
    submission->trace = call.trace;
    StageCall stage_call;
    stage_call.claimant = ClaimantOf(*submission);
    stage_call.cancel = call.cancel;
    stage_call.trace = call.trace;
    const absl::Status added = requests.Add(stage_call, *std::move(submission), backend);
    if (!added.ok()) return Within("requests", i, added);
  }
  return std::move(requests).Plates();
}

absl::StatusOr<std::vector<v1::Job>> JobsService::ValidateAll(
    const std::vector<Plate>& plates, const v1::CreatePlatesRequest& request,
    const rpc::Call& call) {
  std::vector<v1::Job> checked;
  for (const Plate& plate : plates) {
    auto job = Validate(plate.submission, request.requests(plate.request), call);
    if (!job.ok()) return Within("requests", plate.request, job.status());
    checked.push_back(*std::move(job));
  }
  return checked;
}

/// Creates all jobs or none. Returns the error if none was created.
absl::StatusOr<std::vector<JobRecord>> JobsService::CreateAll(std::vector<Submission> plates,
                                                              const CancelToken& cancel) {
  auto created = backend_.intake.CreateAll(std::move(plates), cancel);
  if (!created.ok()) return created.status();
  std::vector<JobRecord> jobs;
  for (Created& each : *created) {
    if (each.fresh) backend_.log.Info("job accepted", FieldsOf(each.job));
    jobs.push_back(std::move(each.job));
  }
  backend_.runner.Wake();
  return jobs;
}

absl::StatusOr<JobRecord> JobsService::Create(const Caller& caller,
                                              const v1::CreateJobRequest& request,
                                              const grpc::ServerContext& context) {
  if (request.advise_orientations())
    return Malformed("advise_orientations", "works only with validate_only");
  if (absl::Status rate = backend_.callers.CheckJobs(caller, 1); !rate.ok()) return rate;
  auto submission = Read(caller, request);
  if (submission.ok()) submission->trace = rpc::TraceOf(context);
  const CancelToken cancel([&] { return context.IsCancelled(); });
  auto created = submission.ok() ? backend_.intake.Create(*std::move(submission), cancel)
                                 : absl::StatusOr<Created>(submission.status());
  if (!created.ok()) {
    backend_.log.Warn("job refused", {{"tenant", caller.tenant},
                                      {"error", std::string(created.status().message())}});
    return created.status();
  }
  if (created->fresh) {
    backend_.log.Info("job accepted", FieldsOf(created->job));
    backend_.runner.Wake();
  }
  return std::move(created->job);
}

absl::StatusOr<Submission> JobsService::Read(const Caller& caller,
                                             const v1::CreateJobRequest& request) {
  if (absl::Status ok = CheckRequestId(request.request_id()); !ok.ok()) return ok;
  const std::string& own = caller.default_profile;
  auto spec =
      WithAllSettings(request.spec(), caller.tenant, own.empty() ? backend_.default_profile : own,
                      backend_.profiles, backend_.presets);
  if (!spec.ok()) return spec.status();
  spec->clear_plate();  // the server sets this field, not the client
  auto job = FromProto(*spec);
  if (!job.ok()) return Within("spec", job.status());
  const auto priority = FromProto(request.priority());
  if (!priority.ok()) return priority.status();
  Submission submission;
  submission.tenant = caller.tenant;
  submission.max_open_jobs = caller.max_open_jobs;
  submission.max_kept_jobs = caller.max_kept_jobs;
  submission.max_kept_bytes = caller.max_kept_bytes;
  submission.request_id = request.request_id();
  submission.spec_digest = Sha256Hex(SpecBytes(request.spec()));
  submission.spec = SpecBytes(*spec);
  submission.request = *std::move(job);
  submission.labels = {request.labels().begin(), request.labels().end()};
  submission.priority = *priority;
  submission.webhook_url = request.webhook_url();
  if (!submission.webhook_url.empty()) {
    absl::Status allowed = backend_.webhook_policy()->Check(caller.tenant, submission.webhook_url);
    if (!allowed.ok()) return allowed;
  }
  if (!request.has_deadline()) return submission;
  const auto deadline_us = FromProto(request.deadline());
  if (!deadline_us.ok()) return Within("deadline", deadline_us.status());
  submission.deadline_us = *deadline_us;
  return submission;
}

absl::StatusOr<v1::Job> JobsService::Validate(const Submission& submission,
                                              const v1::CreateJobRequest& request,
                                              const rpc::Call& call) {
  const auto resolved = backend_.intake.Check(submission, call.cancel);
  if (!resolved.ok()) return resolved.status();
  const auto blobs = backend_.blobs.Of(submission.tenant);
  if (!blobs.ok()) return blobs.status();
  StageCall stage_call;
  stage_call.claimant = ClaimantOf(submission);
  stage_call.cancel = call.cancel;
  stage_call.trace = call.trace;
  const auto reserved = ReserveMeshMemory(stage_call, **resolved, **blobs, backend_.memory);
  if (!reserved.ok()) return reserved.status();
  stage_call.memory = reserved->get();
  auto meshes = LoadMeshes(**resolved, **blobs);
  if (!meshes.ok()) return meshes.status();
  meshes->advise_orientations = request.advise_orientations();
  const config::ResolvedPlate& plate = (*resolved)->plate;
  const auto found =
      LookAt(stage_call, {*std::move(meshes), plate.settings, plate.effective_text, plate.warnings},
             backend_.slicing, backend_.pipeline);
  if (!found.ok()) return found.status();
  v1::Job job;
  job.mutable_spec()->ParseFromString(submission.spec);
  *job.mutable_labels() = request.labels();
  job.set_priority(static_cast<v1::JobPriority>(static_cast<int>(submission.priority) + 1));
  if (request.has_deadline()) *job.mutable_deadline() = request.deadline();
  job.set_settings_digest((*resolved)->settings_digest);
  job.set_build_id(backend_.intake.build_id());
  job.mutable_warnings()->Assign(found->warnings.begin(), found->warnings.end());
  *job.mutable_preflight() = ToProto(
      *found,
      CostOf(backend_.rates, found->print_time_s, found->filament.mass_g,
             config::SettingsOf(plate.settings.process()).MaterialCostPerKg(plate.settings)));
  return job;
}

/// Converts the job with its current progress and its position in the queue.
v1::Job JobsService::Describe(JobRecord job) {
  backend_.feed.AddProgress(job);
  v1::Job answer = ToProto(job);
  queue_.Describe(job, answer);
  DescribeWaiting(backend_.pipeline.executor(), backend_.away_stages, answer);
  return answer;
}

grpc::Status JobsService::GetJob(grpc::ServerContext* context, const v1::GetJobRequest* request,
                                 v1::Job* response) {
  auto job = Find(*context, {Scope::kRead, Scope::kAdmin}, request->id(), Of::kAllForAdmins);
  if (job.ok()) *response = Describe(*std::move(job));
  if (request->view() == v1::JOB_VIEW_BASIC) ClearDetails(*response);
  return rpc::ToGrpc(job.status());
}

grpc::Status JobsService::BatchGetJobs(grpc::ServerContext* context,
                                       const v1::BatchGetJobsRequest* request,
                                       v1::BatchGetJobsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->ids_size() > limits::kMaxBatchJobs) {
    return rpc::ToGrpc(LimitError(Reason::kRequestTooLarge, "jobs of a batch",
                                  limits::kMaxBatchJobs, request->ids_size()));
  }
  for (const std::string& id : request->ids()) {
    auto job = Find(*caller, id, Of::kAllForAdmins);
    v1::BatchGetJobsResponse::Outcome& outcome = *response->add_outcomes();
    if (!job.ok()) {
      *outcome.mutable_error() = ToProto(JobErrorOf(rpc::FromGrpc(rpc::ToGrpc(job.status()))));
      continue;
    }
    *outcome.mutable_job() = Describe(*std::move(job));
    ClearDetails(*outcome.mutable_job());
    outcome.mutable_job()->clear_spec();
  }
  const auto bytes = static_cast<int64_t>(response->ByteSizeLong());
  if (bytes <= kMaxEchoedBytes) return grpc::Status::OK;
  response->Clear();
  return rpc::ToGrpc(LimitError(Reason::kRequestTooLarge, "bytes of the answer; ask for fewer jobs",
                                kMaxEchoedBytes, bytes));
}

grpc::Status JobsService::ListJobs(grpc::ServerContext* context, const v1::ListJobsRequest* request,
                                   v1::ListJobsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  auto query = FromProto(*request);
  if (!query.ok()) return rpc::ToGrpc(query.status());
  const auto tenant = TenantAskedFor(*caller, request->has_tenant(), request->tenant());
  if (!tenant.ok()) return rpc::ToGrpc(tenant.status());
  query->tenant = *tenant;
  query->all_tenants = caller->may(Scope::kAdmin) && !request->has_tenant();
  // All callers share the store's connections, and a list may occupy one for long.
  const auto slot = lists_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  auto jobs = backend_.jobs.List(*query);
  if (!jobs.ok()) return rpc::ToGrpc(jobs.status());
  for (JobRecord& job : *jobs) backend_.feed.AddProgress(job);
  *response = ToProto(*jobs, *query);
  for (int i = 0; i < response->jobs_size(); ++i) {  // a page may be shorter than the list
    v1::Job& job = *response->mutable_jobs(i);
    queue_.Describe((*jobs)[i], job);
    DescribeWaiting(backend_.pipeline.executor(), backend_.away_stages, job);
  }
  return rpc::ToGrpc(jobs.status());
}

void JobsService::ServeFrom(grpc::ServerCompletionQueue& queue) {
  const auto admit = [this](const auto& context) { return AdmitWatch(context); };
  watches_.emplace(JobWatches{*this, queue, watch_reads_, backend_.feed, admit});
  JobWatch::Await(*watches_);
}

absl::StatusOr<Watcher> JobsService::AdmitWatch(const grpc::ServerContext& context) {
  auto caller = backend_.callers.Find(context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return caller.status();
  auto slot = watches_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return slot.status();
  return Watcher{*caller, *std::move(slot)};
}

grpc::Status JobsService::GetWebhook(grpc::ServerContext* context,
                                     const v1::GetWebhookRequest* request, v1::Webhook* response) {
  const auto job = Find(*context, {Scope::kRead}, request->job_id(), Of::kTenant);
  if (!job.ok()) return rpc::ToGrpc(job.status());
  const auto webhook = backend_.webhooks.Get(request->job_id());
  if (webhook.ok() && *webhook) *response = ToProto(**webhook);
  return rpc::ToGrpc(webhook.status());
}

grpc::Status JobsService::DeleteJob(grpc::ServerContext* context,
                                    const v1::DeleteJobRequest* request, google::protobuf::Empty*) {
  const auto known = Find(*context, {Scope::kSubmit}, request->id(), Of::kTenant);
  if (!known.ok()) return rpc::ToGrpc(known.status());
  return rpc::ToGrpc(backend_.jobs.Delete(request->id()));
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenResult(const JobRecord& job,
                                                                    v1::Artifact artifact,
                                                                    int64_t offset) {
  const auto digest = ArtifactOf(job, artifact);
  if (!digest.ok()) return digest.status();
  const auto blobs = backend_.blobs.Of(job.result->tenant);
  if (!blobs.ok()) return blobs.status();
  // The blob stays during the download, even if its job is deleted meanwhile.
  if (const auto kept = (*blobs)->Keep(*digest); !kept.ok()) return kept.status();
  return offset == 0 ? OpenToStream(*blobs, *digest) : (*blobs)->Open(*digest);
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenTrace(const JobRecord& job) {
  auto trace = JobTraces(backend_.jobs, backend_.blobs).Chrome(job);
  if (!trace.ok()) return trace.status();
  return std::make_unique<TextReader>(*std::move(trace));
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenDerived(const JobRecord& job,
                                                                     v1::Artifact artifact) {
  auto bytes = Derive(job, artifact, backend_.blobs);
  if (!bytes.ok()) return bytes.status();
  return std::make_unique<TextReader>(*std::move(bytes));
}

absl::StatusOr<std::unique_ptr<BlobReader>> JobsService::OpenArtifact(
    const Caller& caller, const v1::DownloadRequest& request) {
  const auto job = Find(caller, request.id(), Of::kTenant);
  if (!job.ok()) return job.status();
  auto reader = request.artifact() == v1::ARTIFACT_TRACE ? OpenTrace(*job)
                : IsDerived(request.artifact())
                    ? OpenDerived(*job, request.artifact())
                    : OpenResult(*job, request.artifact(), request.offset());
  if (!reader.ok()) return reader.status();
  absl::Status within = CheckPart(**reader, request.offset(), request.limit());
  if (!within.ok()) return within;
  return reader;
}

grpc::Status JobsService::Download(grpc::ServerContext* context, const v1::DownloadRequest* request,
                                   grpc::ServerWriter<v1::DownloadResponse>* stream) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(downloads_.Run(*context, caller->tenant, [&](const Transfers::Moved& moved) {
    return Send(*caller, *request, moved, *stream);
  }));
}

absl::Status JobsService::Send(const Caller& caller, const v1::DownloadRequest& request,
                               const Transfers::Moved& moved,
                               grpc::ServerWriter<v1::DownloadResponse>& stream) {
  const auto reader = OpenArtifact(caller, request);
  if (!reader.ok()) return reader.status();
  return SendBlob(**reader, request.offset(), request.limit(), moved, stream);
}

}  // namespace slicefarm::coordinator
