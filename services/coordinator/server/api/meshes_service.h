#pragma once

#include "absl/status/statusor.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/memory_budget.h"
#include "services/coordinator/remote/remote_projects.h"
#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/full_queues.h"
#include "services/coordinator/server/api/tenant_budgets.h"
#include "services/coordinator/server/api/tenant_slots.h"
#include "services/coordinator/server/api/transfers.h"
#include "services/coordinator/server/execution/disk_guard.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.grpc.pb.h"

namespace slicefarm::coordinator {

/// Objects that the service uses. All of them must outlive it.
struct MeshesBackend {
  const Callers& callers;
  JobStore& jobs;
  BlobStores& blobs;
  const DiskGuard& disk;
  TenantBudgets& budgets;
  FullQueues& full_queues;
  const ProjectReader& projects;
  MemoryBudget& memory;
  rpc::JsonLog log;
};

/// Implements slicefarm.v1.Meshes with the caller's BlobStore.
class MeshesService final : public v1::Meshes::Service {
 public:
  MeshesService(MeshesBackend backend, const TransferOptions& options)
      : backend_(std::move(backend)),
        uploads_(options),
        downloads_(options),
        projects_({.slots = kProjects}, backend_.log),
        projects_of_tenants_(kProjects),
        lists_of_tenants_(kLists) {}

  grpc::Status GetUpload(grpc::ServerContext* context, const v1::GetUploadRequest* request,
                         v1::Upload* response) override;
  grpc::Status UploadMesh(grpc::ServerContext* context,
                          grpc::ServerReader<v1::UploadMeshRequest>* stream,
                          v1::Upload* response) override;
  grpc::Status DownloadMesh(grpc::ServerContext* context, const v1::DownloadMeshRequest* request,
                            grpc::ServerWriter<v1::DownloadResponse>* stream) override;
  grpc::Status ListMeshes(grpc::ServerContext* context, const v1::ListMeshesRequest* request,
                          v1::ListMeshesResponse* response) override;
  grpc::Status DeleteMesh(grpc::ServerContext* context, const v1::DeleteMeshRequest* request,
                          v1::DeleteMeshResponse* response) override;
  grpc::Status ReadProject(grpc::ServerContext* context, const v1::ReadProjectRequest* request,
                           v1::ReadProjectResponse* response) override;

 private:
  static constexpr int kProjects = 8;  ///< projects that are read at a time
  static constexpr int kLists = 8;

  absl::StatusOr<v1::ReadProjectResponse> ReadStored(const Caller& caller,
                                                     const v1::ReadProjectRequest& request,
                                                     const rpc::Call& call);

  MeshesBackend backend_;
  Transfers uploads_;
  Transfers downloads_;
  rpc::CallLimiter projects_;
  TenantSlots projects_of_tenants_;
  TenantSlots lists_of_tenants_;
};

}  // namespace slicefarm::coordinator
