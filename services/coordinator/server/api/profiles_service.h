#pragma once

#include <functional>

#include "services/coordinator/server/api/callers.h"
#include "services/coordinator/server/execution/disk_guard.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/profiles.grpc.pb.h"

namespace slicefarm::coordinator {

/// Implements slicefarm.v1.Profiles with a ProfileStore. Each tenant has profiles of its own.
class ProfilesService final : public v1::Profiles::Service {
 public:
  /// Creates the service. `callers` and `profiles` must outlive it.
  ProfilesService(const Callers& callers, ProfileStore& profiles, const DiskGuard& disk,
                  std::function<int64_t()> now_us)
      : callers_(callers), profiles_(profiles), disk_(disk), now_us_(std::move(now_us)) {}

  grpc::Status PutProfile(grpc::ServerContext* context, const v1::PutProfileRequest* request,
                          v1::Profile* response) override;
  grpc::Status GetProfile(grpc::ServerContext* context, const v1::GetProfileRequest* request,
                          v1::Profile* response) override;
  grpc::Status ListProfiles(grpc::ServerContext* context, const v1::ListProfilesRequest* request,
                            v1::ListProfilesResponse* response) override;
  grpc::Status DeleteProfile(grpc::ServerContext* context, const v1::DeleteProfileRequest* request,
                             google::protobuf::Empty* response) override;

 private:
  absl::Status Put(const std::string& tenant, const v1::PutProfileRequest& request,
                   v1::Profile* response);
  absl::Status List(const std::string& tenant, const v1::ListProfilesRequest& request,
                    v1::ListProfilesResponse* response);

  const Callers& callers_;
  ProfileStore& profiles_;
  const DiskGuard& disk_;
  const std::function<int64_t()> now_us_;
};

}  // namespace slicefarm::coordinator
