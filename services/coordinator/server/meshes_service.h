#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/server/callers.h"
#include "services/coordinator/server/transfers.h"
#include "services/coordinator/store/blob_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Translates slicefarm.v1.Meshes to a BlobStore.
class MeshesService final : public v1::Meshes::Service {
 public:
  /// `callers` and `blobs` must outlive it.
  MeshesService(const Callers& callers, BlobStore& blobs, const TransferOptions& options)
      : callers_(callers), blobs_(blobs), uploads_(options) {}

  grpc::Status GetUpload(grpc::ServerContext* context, const v1::GetUploadRequest* request,
                         v1::Upload* response) override;

  grpc::Status UploadMesh(grpc::ServerContext* context,
                          grpc::ServerReader<v1::UploadMeshRequest>* stream,
                          v1::Upload* response) override;

 private:
  using Reader = grpc::ServerReader<v1::UploadMeshRequest>;
  absl::Status Take(Reader& stream, const Transfers::Moved& moved, v1::Upload* response);
  absl::StatusOr<BlobStatus> Receive(Reader& stream, const Transfers::Moved& moved,
                                     v1::UploadMeshRequest& first);

  const Callers& callers_;
  BlobStore& blobs_;
  Transfers uploads_;
};

}  // namespace slicefarm::coordinator
