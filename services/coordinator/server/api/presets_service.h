#pragma once

#include <functional>

#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/api/preset_library.h"
#include "services/coordinator/server/api/tenant_budgets.h"
#include "services/coordinator/server/execution/disk_guard.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/presets.grpc.pb.h"

namespace slicefarm::coordinator {

/// Implements slicefarm.v1.Presets. Each tenant has bundles of its own. They are in a ProfileStore,
/// one profile per bundle.
class PresetsService final : public v1::Presets::Service {
 public:
  /// Creates the service. All references must outlive it.
  PresetsService(const Callers& callers, ProfileStore& bundles, PresetLibrary& library,
                 const DiskGuard& disk, TenantBudgets& budgets, std::function<int64_t()> now_us)
      : callers_(callers),
        bundles_(bundles),
        library_(library),
        disk_(disk),
        budgets_(budgets),
        now_us_(std::move(now_us)) {}

  grpc::Status ImportPresets(grpc::ServerContext* context, const v1::ImportPresetsRequest* request,
                             v1::PresetBundle* response) override;
  grpc::Status GetPresetBundle(grpc::ServerContext* context,
                               const v1::GetPresetBundleRequest* request,
                               v1::PresetBundle* response) override;
  grpc::Status ListPresetBundles(grpc::ServerContext* context,
                                 const v1::ListPresetBundlesRequest* request,
                                 v1::ListPresetBundlesResponse* response) override;
  grpc::Status DeletePresetBundle(grpc::ServerContext* context,
                                  const v1::DeletePresetBundleRequest* request,
                                  google::protobuf::Empty* response) override;
  grpc::Status ListPresets(grpc::ServerContext* context, const v1::ListPresetsRequest* request,
                           v1::ListPresetsResponse* response) override;
  grpc::Status ResolvePresets(grpc::ServerContext* context,
                              const v1::ResolvePresetsRequest* request,
                              v1::ResolvedPresets* response) override;

 private:
  absl::Status Import(const Caller& caller, const v1::ImportPresetsRequest& request,
                      v1::PresetBundle* response);
  absl::Status ListBundles(const std::string& tenant, const v1::ListPresetBundlesRequest& request,
                           v1::ListPresetBundlesResponse* response);
  absl::Status ListNames(const std::string& tenant, const v1::ListPresetsRequest& request,
                         v1::ListPresetsResponse* response);
  absl::Status Resolve(const std::string& tenant, const v1::JobPresets& named,
                       v1::ResolvedPresets* response);

  const Callers& callers_;
  ProfileStore& bundles_;
  PresetLibrary& library_;
  const DiskGuard& disk_;
  TenantBudgets& budgets_;
  const std::function<int64_t()> now_us_;
};

}  // namespace slicefarm::coordinator
