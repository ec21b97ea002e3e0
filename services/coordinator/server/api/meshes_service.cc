#include "services/coordinator/server/api/meshes_service.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/blob_download.h"
#include "services/coordinator/server/api/kept_meshes.h"
#include "services/coordinator/server/api/upload_pieces.h"
#include "services/coordinator/server/messages/jobs_wire.h"
#include "services/coordinator/store/blobs/checking_reader.h"

namespace slicefarm::coordinator {
namespace {

absl::Status CheckFirst(const v1::UploadMeshRequest& first) {
  if (!IsSha256Hex(first.sha256())) return Malformed("sha256", "is not 64 lower-case hex digits");
  if (first.size() < 0) return Malformed("size", "is negative");
  if (first.size() > limits::kMaxMeshBytes) {
    return LimitError(Reason::kMeshTooLarge, "bytes of a mesh", limits::kMaxMeshBytes,
                      first.size());
  }
  if (first.write_offset() < 0 || first.write_offset() > first.size()) {
    return Malformed("write_offset", "is not within the mesh");
  }
  return absl::OkStatus();
}

absl::Status CheckChunk(const std::string& data, int64_t offset, int64_t size) {
  const auto bytes = static_cast<int64_t>(data.size());
  if (bytes > limits::kMaxUploadChunkBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a chunk", limits::kMaxUploadChunkBytes,
                      bytes);
  }
  if (offset + bytes <= size) return absl::OkStatus();
  return Malformed("data", "holds more bytes than `size` says");
}

using Reader = grpc::ServerReader<v1::UploadMeshRequest>;

/// Stores the bytes of an upload as they arrive. If the call breaks, the received bytes stay.
/// REQUIRES: CheckFirst.
absl::StatusOr<BlobStatus> Receive(BlobStore& blobs, const DiskGuard& disk, Reader& stream,
                                   const Transfers::Moved& moved,
                                   const v1::UploadMeshRequest& first) {
  const std::string& digest = first.sha256();
  const int64_t size = first.size();
  UploadPieces pieces(first.write_offset(),
                      [&](int64_t offset, std::string_view bytes) -> absl::StatusOr<BlobStatus> {
                        // The check is repeated for each piece, because other calls write as well.
                        absl::Status space = disk.CheckSpace(size - offset);
                        if (!space.ok()) return space;
                        return blobs.Append(digest, offset, bytes);
                      });
  v1::UploadMeshRequest chunk = first;
  do {
    moved(std::ssize(chunk.data()));
    absl::Status added = CheckChunk(chunk.data(), pieces.offset(), size);
    if (added.ok()) added = pieces.Add(chunk.data());
    if (!added.ok()) return added;
    // Protects the mesh until its job is created.
    if (pieces.status().complete) return blobs.Keep(digest);
  } while (stream.Read(&chunk));
  if (absl::Status kept = pieces.KeepRest(); !kept.ok()) return kept;
  if (pieces.offset() < size) return blobs.Status(digest);
  return blobs.Finish(digest, size);
}

}  // namespace

grpc::Status MeshesService::GetUpload(grpc::ServerContext* context,
                                      const v1::GetUploadRequest* request, v1::Upload* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto blobs = backend_.blobs.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  // The caller may create a job with this mesh next.
  const auto status = (*blobs)->Keep(request->sha256());
  if (status.ok()) *response = ToProto(request->sha256(), *status);
  return rpc::ToGrpc(status.status());
}

grpc::Status MeshesService::UploadMesh(grpc::ServerContext* context, Reader* stream,
                                       v1::Upload* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto blobs = backend_.blobs.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  const auto receive = [&](const Transfers::Moved& moved) -> absl::Status {
    v1::UploadMeshRequest first;
    if (!stream->Read(&first)) return Malformed("sha256", "is missing");
    if (absl::Status ok = CheckFirst(first); !ok.ok()) return ok;
    const auto there = (*blobs)->Status(first.sha256());
    if (there.ok() && !there->complete) {
      if (absl::Status space = backend_.full_queues.Check(caller->tenant); !space.ok())
        return space;
      const absl::Status space = backend_.budgets.CheckBytes(caller->tenant, caller->max_kept_bytes,
                                                             first.size() - there->committed_size);
      if (!space.ok()) return space;
    }
    const auto status = Receive(**blobs, backend_.disk, *stream, moved, first);
    if (status.ok()) *response = ToProto(first.sha256(), *status);
    return status.status();
  };
  return rpc::ToGrpc(uploads_.Run(*context, caller->tenant, receive));
}

grpc::Status MeshesService::DownloadMesh(grpc::ServerContext* context,
                                         const v1::DownloadMeshRequest* request,
                                         grpc::ServerWriter<v1::DownloadResponse>* stream) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto send = [&](const Transfers::Moved& moved) -> absl::Status {
    const auto blobs = backend_.blobs.Of(caller->tenant);
    if (!blobs.ok()) return blobs.status();
    if (const auto kept = (*blobs)->Keep(request->sha256()); !kept.ok()) return kept.status();
    const bool streams = request->offset() == 0 && request->limit() == 0;
    const auto mesh =
        streams ? OpenToStream(*blobs, request->sha256()) : (*blobs)->Open(request->sha256());
    if (!mesh.ok()) return mesh.status();
    const absl::Status within = CheckPart(**mesh, request->offset(), request->limit());
    if (!within.ok()) return within;
    return SendBlob(**mesh, request->offset(), request->limit(), moved, *stream);
  };
  return rpc::ToGrpc(downloads_.Run(*context, caller->tenant, send));
}

grpc::Status MeshesService::ListMeshes(grpc::ServerContext* context,
                                       const v1::ListMeshesRequest* request,
                                       v1::ListMeshesResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->page_size() < 0) return rpc::ToGrpc(Malformed("page_size", "is negative"));
  const int32_t size = request->page_size() == 0
                           ? kDefaultPageSize
                           : std::min(request->page_size(), limits::kMaxPageSize);
  // The method reads the list of all blobs of the tenant, so the number of such calls is limited.
  const auto slot = lists_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  const auto blobs = backend_.blobs.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  const auto page =
      MeshesAfter(**blobs, backend_.jobs, caller->tenant, request->page_token(), size);
  if (page.ok()) *response = *page;
  return rpc::ToGrpc(page.status());
}

grpc::Status MeshesService::DeleteMesh(grpc::ServerContext* context,
                                       const v1::DeleteMeshRequest* request,
                                       v1::DeleteMeshResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto blobs = backend_.blobs.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  const auto deleted = DeleteUnlessUsed(**blobs, backend_.jobs, caller->tenant, request->sha256());
  if (deleted.ok()) response->set_deleted(*deleted);
  return rpc::ToGrpc(deleted.status());
}

grpc::Status MeshesService::ReadProject(grpc::ServerContext* context,
                                        const v1::ReadProjectRequest* request,
                                        v1::ReadProjectResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto slot = projects_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  return projects_.Run(*context, "ReadProject", [&](const rpc::Call& call) {
    auto project = ReadStored(*caller, *request, call);
    if (project.ok()) *response = *std::move(project);
    return project.status();
  });
}

absl::StatusOr<v1::ReadProjectResponse> MeshesService::ReadStored(
    const Caller& caller, const v1::ReadProjectRequest& request, const rpc::Call& call) {
  const auto blobs = backend_.blobs.Of(caller.tenant);
  if (!blobs.ok()) return blobs.status();
  const auto status = (*blobs)->Keep(request.sha256());
  if (!status.ok()) return status.status();
  StageCall stage_call;
  stage_call.claimant.tenant = caller.tenant;
  stage_call.cancel = call.cancel;
  stage_call.trace = call.trace;
  const auto space =
      backend_.memory.Take(stage_call.claimant, "", status->committed_size, call.cancel);
  if (!space.ok()) return space.status();
  auto bytes = (*blobs)->Get(request.sha256());
  if (!bytes.ok()) return bytes.status();
  auto project = backend_.projects.Read(
      stage_call, {.name = "project", .format = MeshFormat::k3mf, .bytes = *std::move(bytes)});
  if (!project.ok()) return project;
  return WithSpecOf(request.plate(), *std::move(project));
}

}  // namespace slicefarm::coordinator
