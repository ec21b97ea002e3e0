#include "services/coordinator/server/api/meshes_service.h"

#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/jobs_wire.h"
#include "services/coordinator/server/api/upload_pieces.h"

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
  if (bytes > limits::kUploadChunkBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a chunk", limits::kUploadChunkBytes,
                      bytes);
  }
  if (offset + bytes <= size) return absl::OkStatus();
  return Malformed("data", "holds more bytes than `size` says");
}

using Reader = grpc::ServerReader<v1::UploadMeshRequest>;

/// Keeps what comes; a call that breaks leaves what it brought. REQUIRES: CheckFirst.
absl::StatusOr<BlobStatus> Receive(BlobStore& blobs, const DiskGuard& disk, Reader& stream,
                                   const Transfers::Moved& moved,
                                   const v1::UploadMeshRequest& first) {
  const std::string& digest = first.sha256();
  const int64_t size = first.size();
  UploadPieces pieces(first.write_offset(),
                      [&](int64_t offset, std::string_view bytes) -> absl::StatusOr<BlobStatus> {
                        // Each time, as others write as well.
                        absl::Status room = disk.CheckRoom(size - offset);
                        if (!room.ok()) return room;
                        return blobs.Append(digest, offset, bytes);
                      });
  v1::UploadMeshRequest chunk = first;
  do {
    moved(std::ssize(chunk.data()));
    absl::Status added = CheckChunk(chunk.data(), pieces.offset(), size);
    if (added.ok()) added = pieces.Add(chunk.data());
    if (!added.ok()) return added;
    if (pieces.status().complete) return blobs.Keep(digest);  // until its job is made
  } while (stream.Read(&chunk));
  if (absl::Status kept = pieces.KeepRest(); !kept.ok()) return kept;
  if (pieces.offset() < size) return blobs.Status(digest);
  return blobs.Finish(digest, size);
}

}  // namespace

grpc::Status MeshesService::GetUpload(grpc::ServerContext* context,
                                      const v1::GetUploadRequest* request, v1::Upload* response) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto blobs = blobs_.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  const auto status = (*blobs)->Keep(request->sha256());  // who asks, may make a job of it next
  if (status.ok()) *response = ToProto(request->sha256(), *status);
  return rpc::ToGrpc(status.status());
}

grpc::Status MeshesService::UploadMesh(grpc::ServerContext* context, Reader* stream,
                                       v1::Upload* response) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto blobs = blobs_.Of(caller->tenant);
  if (!blobs.ok()) return rpc::ToGrpc(blobs.status());
  const auto receive = [&](const Transfers::Moved& moved) -> absl::Status {
    v1::UploadMeshRequest first;
    if (!stream->Read(&first)) return Malformed("sha256", "is missing");
    if (absl::Status ok = CheckFirst(first); !ok.ok()) return ok;
    const auto there = (*blobs)->Status(first.sha256());
    if (there.ok() && !there->complete) {
      if (absl::Status room = full_queues_.Check(caller->tenant); !room.ok()) return room;
      const absl::Status room = budgets_.CheckBytes(caller->tenant, caller->max_kept_bytes,
                                                    first.size() - there->committed_size);
      if (!room.ok()) return room;
    }
    const auto status = Receive(**blobs, disk_, *stream, moved, first);
    if (status.ok()) *response = ToProto(first.sha256(), *status);
    return status.status();
  };
  return rpc::ToGrpc(uploads_.Run(*context, caller->tenant, receive));
}

}  // namespace slicefarm::coordinator
