// Methods of JobsService that export and erase all data of a tenant.
#include "common/base/cancel_scope.h"
#include "common/rpc/status_mapping.h"
#include "services/coordinator/server/api/blob_download.h"
#include "services/coordinator/server/api/farm_facts.h"
#include "services/coordinator/server/api/jobs_service.h"
#include "services/coordinator/server/api/tenant_data.h"

namespace slicefarm::coordinator {

grpc::Status JobsService::ExportTenant(grpc::ServerContext* context,
                                       const v1::ExportTenantRequest* request,
                                       grpc::ServerWriter<v1::DownloadResponse>* stream) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto tenant = TenantAskedFor(*caller, /*asked=*/true, request->tenant());
  if (!tenant.ok()) return rpc::ToGrpc(tenant.status());
  const TenantData data = {backend_.jobs, backend_.blobs, backend_.profiles,
                           backend_.preset_bundles};
  return rpc::ToGrpc(downloads_.Run(*context, caller->tenant, [&](const Transfers::Moved& moved) {
    return coordinator::ExportTenant(
        *tenant, data, backend_.now_us(), CancelScope::Current(),
        [&](std::string_view bytes) { return SendBytes(bytes, moved, *stream); });
  }));
}

grpc::Status JobsService::EraseTenant(grpc::ServerContext* context,
                                      const v1::EraseTenantRequest* request,
                                      v1::EraseTenantResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kSubmit, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto tenant = TenantAskedFor(*caller, /*asked=*/true, request->tenant());
  if (!tenant.ok()) return rpc::ToGrpc(tenant.status());
  const CancelScope scope(CancelToken([&] { return context->IsCancelled(); }));
  const auto erased = coordinator::EraseTenant(
      *tenant, {backend_.jobs, backend_.blobs, backend_.profiles, backend_.preset_bundles},
      backend_.now_us, CancelScope::Current(), [&](const std::string& job) {
        backend_.runner.Cancel(job);
        backend_.feed.Changed(job);
      });
  backend_.presets.Forget(*tenant);
  if (erased.ok()) *response = *erased;
  return rpc::ToGrpc(erased.status());
}

}  // namespace slicefarm::coordinator
