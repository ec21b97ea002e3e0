#include "services/cli/farm/jobs_client.h"

#include <fmt/core.h>
#include <grpcpp/support/async_stream.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/client_call.h"
#include "common/rpc/retry_after.h"
#include "common/rpc/status_mapping.h"
#include "services/cli/farm/job_outcome.h"
#include "services/cli/farm/jobs_client_call.h"

namespace slicefarm::cli {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kUnaryDeadline{20'000};
constexpr milliseconds kTransferDeadline{600'000};  // a new call continues the transfer
/// Deadline of one watch. A watch that was open continues after it, even without any event.
constexpr milliseconds kWatchDeadline{3'600'000};
constexpr milliseconds kMinRest{100};
constexpr milliseconds kMaxRest{1'000};
constexpr milliseconds kMaxAskedRest{5'000};

/// Returns true if the call may succeed later: the server does not answer, or requests a retry.
bool OutOfReach(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status) ||
         DetailOf(status).reason == Reason::kOverloaded ||
         DetailOf(status).metadata.contains(rpc::kRetryAfterMs);
}

/// Returns a UUID, version 4.
std::string NewRequestId() {
  std::random_device random;
  const auto bits = [&](uint32_t mask) { return random() & mask; };
  return fmt::format("{:08x}-{:04x}-{:04x}-{:04x}-{:08x}{:04x}", bits(0xffffffff), bits(0xffff),
                     0x4000 | bits(0x0fff), 0x8000 | bits(0x3fff), bits(0xffffffff), bits(0xffff));
}

/// Passes each message of a stream to `take`, until the stream ends or `take` returns an error.
/// Sets `opened` when the server confirms the stream.
template <typename Response, typename Start>
absl::Status ReadStream(const rpc::ClientCallOptions& options, const Start& start, bool* opened,
                        const std::function<absl::Status(const Response&)>& take) {
  rpc::ClientCall call(options);
  const std::unique_ptr<grpc::ClientAsyncReader<Response>> reader =
      start(call.context(), call.queue());
  reader->StartCall(nullptr);
  absl::Status taken;
  Response response;
  bool alive = call.Await();
  if (alive) {
    // A stream without messages proves only by its metadata that it reached the server. A server
    // that refuses a call sends trailers only, and no metadata here.
    reader->ReadInitialMetadata(nullptr);
    alive = call.Await();
    if (!call.context()->GetServerInitialMetadata().empty()) *opened = true;
  }
  while (alive) {
    reader->Read(&response, nullptr);
    alive = call.Await();
    if (!alive) break;
    taken = take(response);
    if (taken.ok()) continue;
    call.context()->TryCancel();
    alive = false;
  }
  grpc::Status status;
  reader->Finish(&status, nullptr);
  call.Await();
  return taken.ok() ? call.Outcome(status) : taken;
}

/// Returns the digest of an artifact; empty if the result does not have it.
std::string DigestOf(const v1::JobResult& result, v1::Artifact artifact) {
  if (artifact == v1::ARTIFACT_GCODE) return result.gcode_sha256();
  return artifact == v1::ARTIFACT_REPORT ? result.report_sha256() : "";
}

absl::Status CheckDigest(const std::string& wanted, const std::string& got) {
  if (wanted.empty() || wanted == got) return absl::OkStatus();
  return MakeError(absl::StatusCode::kDataLoss, Reason::kBlobDigestMismatch,
                   "the received file differs from the job's result; fetch it again",
                   {{"sha256", wanted}, {"got", got}});
}

}  // namespace

JobsClient::JobsClient(JobsClientOptions options)
    : options_(std::move(options)),
      connection_(rpc::Secured({.max_message_bytes = limits::kMaxPublicMessageBytes},
                               options_.security, options_.server)),
      channel_(rpc::MakeChannel(options_.server, connection_.value_or(rpc::ChannelOptions()))),
      meshes_(v1::Meshes::NewStub(channel_)),
      jobs_(v1::Jobs::NewStub(channel_)),
      profiles_(v1::Profiles::NewStub(channel_)),
      presets_(v1::Presets::NewStub(channel_)) {}

/// Repeats the attempt until it succeeds or fails with an error other than an unreachable server.
///
/// The patience counts from the first attempt without any answer. A stream that was open for a long
/// time before it broke does not count, because the server may have been reachable until then. An
/// attempt that made progress sets answered_.
absl::Status JobsClient::Persist(const Attempt& attempt) {
  if (!connection_.ok()) return connection_.status();
  const double patience_s = std::chrono::duration<double>(options_.patience).count();
  constexpr double kNotAway = std::numeric_limits<double>::infinity();
  double away_since_s = kNotAway;
  for (milliseconds rest = kMinRest;; rest = std::min(rest * 2, kMaxRest)) {
    answered_ = false;
    absl::Status status = attempt();
    if (status.ok() || !OutOfReach(status)) return status;
    if (answered_) {
      rest = kMinRest;
      away_since_s = kNotAway;
    } else {
      away_since_s = std::min(away_since_s, clock_.Seconds());
    }
    if (clock_.Seconds() - away_since_s >= patience_s) {
      const ErrorDetail detail = DetailOf(status);
      return MakeError(status.code(), detail.reason,
                       fmt::format("{}: {}{}", options_.server, std::string(status.message()),
                                   rpc::ConnectionHint(status, options_.security)),
                       detail.metadata);
    }
    const milliseconds asked = std::min(rpc::RetryAfter(status), kMaxAskedRest);
    absl::Status rested = rpc::AwaitRetry(std::max(rest, asked), options_.cancel);
    if (!rested.ok()) return rested;
  }
}

absl::StatusOr<std::string> JobsClient::UploadMesh(std::string_view bytes,
                                                   const std::function<void(int64_t)>& sent) {
  const std::string sha256 = Sha256Hex(bytes);
  v1::GetUploadRequest request;
  request.set_sha256(sha256);
  int64_t had = -1;  // bytes on the server at the previous attempt
  const absl::Status status = Persist([&]() -> absl::Status {
    v1::Upload upload;
    const absl::Status got =
        rpc::UnaryCall({kUnaryDeadline, options_.cancel, options_.trace}, request, &upload,
                       [&](auto... arguments) { return meshes_->AsyncGetUpload(arguments...); });
    if (!got.ok()) return got;
    answered_ = true;
    if (upload.committed_size() < 0 ||
        upload.committed_size() > static_cast<int64_t>(bytes.size())) {
      return MakeError(absl::StatusCode::kInternal, Reason::kBlobDigestMismatch,
                       fmt::format("the server reports {} bytes of a mesh that has only {} bytes",
                                   upload.committed_size(), bytes.size()));
    }
    sent(upload.committed_size());
    if (upload.complete()) return absl::OkStatus();
    absl::Status outcome = SendFrom(upload.committed_size(), sha256, bytes, sent);
    // A server without disk space answers each time and first accepts some bytes. So only progress
    // counts as an answer.
    if (DetailOf(outcome).reason == Reason::kDiskLow) answered_ = upload.committed_size() > had;
    had = upload.committed_size();
    return outcome;
  });
  if (!status.ok()) return status;
  return sha256;
}

absl::Status JobsClient::SendFrom(int64_t offset, const std::string& sha256, std::string_view bytes,
                                  const std::function<void(int64_t)>& sent) {
  rpc::ClientCall call({kTransferDeadline, options_.cancel, options_.trace});
  v1::Upload upload;
  const auto writer = meshes_->PrepareAsyncUploadMesh(call.context(), &upload, call.queue());
  writer->StartCall(nullptr);
  bool alive = call.Await();
  v1::UploadMeshRequest chunk;
  chunk.set_sha256(sha256);
  chunk.set_size(static_cast<int64_t>(bytes.size()));
  chunk.set_write_offset(offset);
  do {  // at least once: the first message has the digest and size
    const std::string_view piece = bytes.substr(offset, limits::kUploadChunkBytes);
    chunk.set_data(piece.data(), piece.size());
    if (alive) {
      writer->Write(chunk, nullptr);
      alive = call.Await();
    }
    if (!alive) break;
    offset += static_cast<int64_t>(piece.size());
    answered_ = true;
    sent(offset);
    chunk.Clear();
  } while (offset < static_cast<int64_t>(bytes.size()));
  if (alive) {
    writer->WritesDone(nullptr);
    call.Await();
  }
  grpc::Status status;
  writer->Finish(&status, nullptr);
  call.Await();
  if (absl::Status outcome = call.Outcome(status); !outcome.ok()) {
    // Another client may have sent bytes of the same mesh meanwhile.
    if (DetailOf(outcome).reason != Reason::kUploadOffset) return outcome;
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     std::string(outcome.message()));
  }
  if (upload.complete()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                   fmt::format("the upload is incomplete: the server has {} of {} bytes",
                               upload.committed_size(), bytes.size()));
}

absl::StatusOr<v1::Job> JobsClient::CreateJob(v1::CreateJobRequest request) {
  request.set_request_id(NewRequestId());
  // A preflight slices the mesh before it answers.
  return Call<v1::Job>(
      request, [&](auto... a) { return jobs_->AsyncCreateJob(a...); },
      request.validate_only() ? kTransferDeadline : kUnaryDeadline);
}

absl::StatusOr<v1::CreatePlatesResponse> JobsClient::CreatePlates(v1::CreatePlatesRequest request) {
  request.set_request_id(NewRequestId());
  // The server reads the meshes before it answers.
  return Call<v1::CreatePlatesResponse>(
      request, [&](auto... a) { return jobs_->AsyncCreatePlates(a...); }, kTransferDeadline);
}

absl::StatusOr<std::string> JobsClient::FullId(const std::string& beginning) {
  constexpr size_t kIdCharacters = 32;
  constexpr size_t kFewest = 4;
  constexpr int kMostPages = 10;
  const bool is_hex = beginning.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (beginning.size() >= kIdCharacters || beginning.size() < kFewest || !is_hex) return beginning;
  std::vector<std::string> found;
  v1::ListJobsRequest request;
  request.set_page_size(limits::kMaxPageSize);
  for (int i = 0; i < kMostPages; ++i) {
    const auto page = ListJobs(request);
    if (!page.ok()) return page.status();
    for (const v1::Job& job : page->jobs())
      if (job.id().starts_with(beginning)) found.push_back(job.id());
    request.set_page_token(page->next_page_token());
    if (request.page_token().empty()) break;
  }
  if (found.size() == 1) return found.front();
  if (found.empty())
    return MakeError(absl::StatusCode::kNotFound, Reason::kJobNotFound,
                     fmt::format("there is no job whose id begins with '{}'", beginning));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{} jobs have ids that begin with '{}', such as {} and {}: give "
                               "more characters of the id",
                               found.size(), beginning, found[0], found[1]));
}

absl::StatusOr<v1::Job> JobsClient::GetJob(const std::string& id, v1::JobView view) {
  v1::GetJobRequest request;
  request.set_id(id);
  request.set_view(view);
  return Call<v1::Job>(request, [&](auto... a) { return jobs_->AsyncGetJob(a...); });
}

absl::StatusOr<v1::Job> JobsClient::CancelJob(const std::string& id) {
  v1::CancelJobRequest request;
  request.set_id(id);
  return Call<v1::Job>(request, [&](auto... a) { return jobs_->AsyncCancelJob(a...); });
}

absl::Status JobsClient::DeleteJob(const std::string& id) {
  v1::DeleteJobRequest request;
  request.set_id(id);
  int attempts = 0;
  const absl::Status deleted = Call<google::protobuf::Empty>(request, [&](auto... a) {
                                 ++attempts;
                                 return jobs_->AsyncDeleteJob(a...);
                               }).status();
  // An attempt without an answer may have deleted the job, so NotFound after it is a success.
  return absl::IsNotFound(deleted) && attempts > 1 ? absl::OkStatus() : deleted;
}

absl::StatusOr<v1::BatchCancelJobsResponse> JobsClient::CancelJobs(
    const v1::BatchCancelJobsRequest& request) {
  return Call<v1::BatchCancelJobsResponse>(
      request, [&](auto... a) { return jobs_->AsyncBatchCancelJobs(a...); });
}

absl::StatusOr<v1::Job> JobsClient::UpdateJob(const v1::UpdateJobRequest& request) {
  return Call<v1::Job>(request, [&](auto... a) { return jobs_->AsyncUpdateJob(a...); });
}

absl::StatusOr<v1::ListArtifactsResponse> JobsClient::ListArtifacts(const std::string& job_id) {
  v1::ListArtifactsRequest request;
  request.set_id(job_id);
  return Call<v1::ListArtifactsResponse>(
      request, [&](auto... a) { return jobs_->AsyncListArtifacts(a...); }, kTransferDeadline);
}

absl::StatusOr<v1::GetCallerResponse> JobsClient::GetCaller() {
  return Call<v1::GetCallerResponse>(v1::GetCallerRequest(),
                                     [&](auto... a) { return jobs_->AsyncGetCaller(a...); });
}

absl::StatusOr<v1::Usage> JobsClient::GetUsage(const v1::GetUsageRequest& request) {
  return Call<v1::Usage>(request, [&](auto... a) { return jobs_->AsyncGetUsage(a...); });
}

absl::Status JobsClient::ExportTenant(const std::string& tenant, OutputFile& file) {
  constexpr std::chrono::hours kLongest(24);
  v1::ExportTenantRequest request;
  request.set_tenant(tenant);
  if (!connection_.ok()) return connection_.status();
  return ReadStream<v1::DownloadResponse>(
      {kLongest, options_.cancel, options_.trace},
      [&](grpc::ClientContext* context, grpc::CompletionQueue* queue) {
        return jobs_->PrepareAsyncExportTenant(context, request, queue);
      },
      &answered_,
      [&](const v1::DownloadResponse& response) { return file.Write(response.data()); });
}

absl::StatusOr<v1::EraseTenantResponse> JobsClient::EraseTenant(const std::string& tenant) {
  v1::EraseTenantRequest request;
  request.set_tenant(tenant);
  return Call<v1::EraseTenantResponse>(
      request, [&](auto... a) { return jobs_->AsyncEraseTenant(a...); }, kTransferDeadline);
}

absl::StatusOr<v1::ListMeshesResponse> JobsClient::ListMeshes(
    const v1::ListMeshesRequest& request) {
  return Call<v1::ListMeshesResponse>(request,
                                      [&](auto... a) { return meshes_->AsyncListMeshes(a...); });
}

/// Deletes a mesh. An attempt without an answer may have deleted it, so NotFound may follow.
absl::StatusOr<bool> JobsClient::DeleteMesh(const std::string& sha256) {
  v1::DeleteMeshRequest request;
  request.set_sha256(sha256);
  int attempts = 0;
  const auto done = Call<v1::DeleteMeshResponse>(request, [&](auto... a) {
    ++attempts;
    return meshes_->AsyncDeleteMesh(a...);
  });
  if (!done.ok()) return done.status();
  return done->deleted() || attempts > 1;
}

absl::Status JobsClient::DownloadMesh(const std::string& sha256, OutputFile& file) {
  v1::DownloadMeshRequest request;
  request.set_sha256(sha256);
  Sha256 sha;
  const absl::Status status = Persist([&] {
    return ReadStream<v1::DownloadResponse>(
        {kTransferDeadline, options_.cancel, options_.trace},
        [&](grpc::ClientContext* context, grpc::CompletionQueue* queue) {
          return meshes_->PrepareAsyncDownloadMesh(context, request, queue);
        },
        &answered_,
        [&](const v1::DownloadResponse& response) {
          answered_ = true;
          request.set_offset(request.offset() + static_cast<int64_t>(response.data().size()));
          sha.Add(response.data());
          return file.Write(response.data());
        });
  });
  return status.ok() ? CheckDigest(sha256, sha.Hex()) : status;
}

absl::StatusOr<v1::Webhook> JobsClient::GetWebhook(const std::string& job_id) {
  v1::GetWebhookRequest request;
  request.set_job_id(job_id);
  return Call<v1::Webhook>(request, [&](auto... a) { return jobs_->AsyncGetWebhook(a...); });
}

absl::StatusOr<v1::ListJobsResponse> JobsClient::ListJobs(const v1::ListJobsRequest& request) {
  return Call<v1::ListJobsResponse>(request, [&](auto... a) { return jobs_->AsyncListJobs(a...); });
}

absl::StatusOr<v1::Job> JobsClient::WatchJob(const std::string& id,
                                             const std::function<void(const v1::Job&)>& changed) {
  v1::WatchJobRequest request;
  request.set_id(id);
  v1::Job last;
  const absl::Status status = Persist([&]() -> absl::Status {
    const absl::Status end = ReadStream<v1::JobEvent>(
        {kWatchDeadline, options_.cancel, options_.trace},
        [&](grpc::ClientContext* context, grpc::CompletionQueue* queue) {
          return jobs_->PrepareAsyncWatchJob(context, request, queue);
        },
        &answered_,
        [&](const v1::JobEvent& event) {
          answered_ = true;
          request.set_after_sequence(event.sequence());
          last = event.job();
          changed(last);
          return absl::OkStatus();
        });
    if (!end.ok() || HasEnded(last)) return end;
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "the server ended the stream of job states before the job had ended");
  });
  if (!status.ok()) return status;
  return last;
}

absl::Status JobsClient::WatchJobs(
    v1::WatchJobsRequest request,
    const std::function<absl::Status(const v1::WatchJobsResponse&)>& on_response) {
  absl::Status enough;
  const absl::Status status = Persist([&]() -> absl::Status {
    absl::Status end = ReadStream<v1::WatchJobsResponse>(
        {kWatchDeadline, options_.cancel, options_.trace},
        [&](grpc::ClientContext* context, grpc::CompletionQueue* queue) {
          return jobs_->PrepareAsyncWatchJobs(context, request, queue);
        },
        &answered_,
        [&](const v1::WatchJobsResponse& response) {
          answered_ = true;
          request.set_cursor(response.cursor());
          enough = on_response(response);
          return enough;
        });
    if (!enough.ok()) return absl::OkStatus();
    if (!end.ok()) return end;
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "the server ended the stream of events");
  });
  return enough.ok() ? status : enough;
}

absl::Status JobsClient::Download(const v1::Job& job, v1::Artifact artifact, OutputFile& file) {
  return Receive(job, artifact, [&](std::string_view bytes) { return file.Write(bytes); });
}

absl::StatusOr<std::string> JobsClient::DownloadText(const v1::Job& job, v1::Artifact artifact) {
  std::string text;
  absl::Status received = Receive(job, artifact, [&](std::string_view bytes) {
    text += bytes;
    return absl::OkStatus();
  });
  if (!received.ok()) return received;
  return text;
}

absl::Status JobsClient::Receive(const v1::Job& job, v1::Artifact artifact, const Write& write) {
  v1::DownloadRequest request;
  request.set_id(job.id());
  request.set_artifact(artifact);
  Sha256 sha;
  const absl::Status status = Persist([&] {
    return ReadStream<v1::DownloadResponse>(
        {kTransferDeadline, options_.cancel, options_.trace},
        [&](grpc::ClientContext* context, grpc::CompletionQueue* queue) {
          return jobs_->PrepareAsyncDownload(context, request, queue);
        },
        &answered_,
        [&](const v1::DownloadResponse& response) {
          answered_ = true;
          request.set_offset(request.offset() + static_cast<int64_t>(response.data().size()));
          sha.Add(response.data());
          return write(response.data());
        });
  });
  return status.ok() ? CheckDigest(DigestOf(job.result(), artifact), sha.Hex()) : status;
}

}  // namespace slicefarm::cli
