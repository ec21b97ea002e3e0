#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/store/blob_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Translates slicefarm.v1.Meshes to a BlobStore.
class MeshesService final : public v1::Meshes::Service {
 public:
  explicit MeshesService(BlobStore& blobs) : blobs_(blobs) {}

  grpc::Status GetUpload(grpc::ServerContext* context, const v1::GetUploadRequest* request,
                         v1::Upload* response) override;

  grpc::Status UploadMesh(grpc::ServerContext* context,
                          grpc::ServerReader<v1::UploadMeshRequest>* stream,
                          v1::Upload* response) override;

 private:
  absl::StatusOr<BlobStatus> Receive(grpc::ServerReader<v1::UploadMeshRequest>& stream,
                                     v1::UploadMeshRequest& first);

  BlobStore& blobs_;
};

}  // namespace slicefarm::coordinator
