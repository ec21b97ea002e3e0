#pragma once

#include "absl/status/statusor.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/full_queues.h"
#include "services/coordinator/server/api/tenant_budgets.h"
#include "services/coordinator/server/api/transfers.h"
#include "services/coordinator/server/execution/disk_guard.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Translates slicefarm.v1.Meshes to the caller's BlobStore.
class MeshesService final : public v1::Meshes::Service {
 public:
  /// All but `options` must outlive it.
  MeshesService(const Callers& callers, BlobStores& blobs, const DiskGuard& disk,
                TenantBudgets& budgets, FullQueues& full_queues, const TransferOptions& options)
      : callers_(callers),
        blobs_(blobs),
        disk_(disk),
        budgets_(budgets),
        full_queues_(full_queues),
        uploads_(options) {}

  grpc::Status GetUpload(grpc::ServerContext* context, const v1::GetUploadRequest* request,
                         v1::Upload* response) override;

  grpc::Status UploadMesh(grpc::ServerContext* context,
                          grpc::ServerReader<v1::UploadMeshRequest>* stream,
                          v1::Upload* response) override;

 private:
  const Callers& callers_;
  BlobStores& blobs_;
  const DiskGuard& disk_;
  TenantBudgets& budgets_;
  FullQueues& full_queues_;
  Transfers uploads_;
};

}  // namespace slicefarm::coordinator
