#include "services/coordinator/server/api/profiles_service.h"

#include <algorithm>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/config/resolve.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/profile_settings.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

absl::Status CheckSettings(const google::protobuf::RepeatedPtrField<v1::Setting>& settings) {
  const std::vector<Setting> given = SettingsFromProto(settings);
  const absl::Status of_most = config::Resolve(given, kDefaultProcess).status();
  if (of_most.ok()) return of_most;
  for (const ProcessInfo& info : kProcesses)
    if (config::Resolve(given, info.process).ok()) return absl::OkStatus();
  return of_most;
}

}  // namespace

grpc::Status ProfilesService::PutProfile(grpc::ServerContext* context,
                                         const v1::PutProfileRequest* request,
                                         v1::Profile* response) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(Put(caller->tenant, *request, response));
}

absl::Status ProfilesService::Put(const std::string& tenant, const v1::PutProfileRequest& request,
                                  v1::Profile* response) {
  if (absl::Status named = CheckProfileName(request.name()); !named.ok()) return named;
  if (request.base_revision() < 0) return Malformed("base_revision", "is negative");
  std::string bytes = ProfileBytes(request.settings());
  if (std::ssize(bytes) > limits::kMaxSpecBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a profile", limits::kMaxSpecBytes,
                      std::ssize(bytes));
  }
  if (absl::Status known = CheckSettings(request.settings()); !known.ok()) return known;
  if (absl::Status space = disk_.CheckSpace(); !space.ok()) return space;
  const std::string digest = Sha256Hex(bytes);
  NewProfile profile = {tenant, request.name(), std::move(bytes), digest};
  if (request.has_base_revision()) profile.base = request.base_revision();
  const auto record = profiles_.Put(profile, now_us_());
  if (!record.ok()) return record.status();
  auto stored = ReadProfile(*record);
  if (stored.ok()) *response = *std::move(stored);
  return stored.status();
}

grpc::Status ProfilesService::GetProfile(grpc::ServerContext* context,
                                         const v1::GetProfileRequest* request,
                                         v1::Profile* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->revision() < 0) return rpc::ToGrpc(Malformed("revision", "is negative"));
  const auto record = profiles_.Get(caller->tenant, request->name(), request->revision());
  if (!record.ok()) return rpc::ToGrpc(record.status());
  auto profile = ReadProfile(*record);
  if (profile.ok()) *response = *std::move(profile);
  return rpc::ToGrpc(profile.status());
}

grpc::Status ProfilesService::ListProfiles(grpc::ServerContext* context,
                                           const v1::ListProfilesRequest* request,
                                           v1::ListProfilesResponse* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(List(caller->tenant, *request, response));
}

grpc::Status ProfilesService::DeleteProfile(grpc::ServerContext* context,
                                            const v1::DeleteProfileRequest* request,
                                            google::protobuf::Empty*) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->revision() < 0) return rpc::ToGrpc(Malformed("revision", "is negative"));
  return rpc::ToGrpc(
      profiles_.Delete(caller->tenant, request->name(), request->revision(), now_us_()));
}

absl::Status ProfilesService::List(const std::string& tenant,
                                   const v1::ListProfilesRequest& request,
                                   v1::ListProfilesResponse* response) {
  if (request.page_size() < 0) return Malformed("page_size", "is negative");
  const int32_t limit = request.page_size() == 0
                            ? kDefaultPageSize
                            : std::min(request.page_size(), limits::kMaxPageSize);
  const auto records = profiles_.List(tenant, request.page_token(), limit);
  if (!records.ok()) return records.status();
  for (const ProfileRecord& record : *records) {
    auto profile = ReadProfile(record);
    if (!profile.ok()) return profile.status();
    *response->add_profiles() = *std::move(profile);
  }
  if (std::ssize(*records) == limit) response->set_next_page_token(records->back().name);
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
