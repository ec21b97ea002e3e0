// Methods of JobsService that report facts about callers, tenants and settings.
#include "common/base/cancel_scope.h"
#include "common/config/table/settings_table.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/enum_wire.h"
#include "services/coordinator/server/api/derived_artifacts.h"
#include "services/coordinator/server/api/farm_facts.h"
#include "services/coordinator/server/api/jobs_service.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {

grpc::Status JobsService::GetCaller(grpc::ServerContext* context, const v1::GetCallerRequest*,
                                    v1::GetCallerResponse* response) {
  const auto caller =
      backend_.callers.Find(*context, {Scope::kSubmit, Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto bounded = [](int64_t most) { return most == INT64_MAX ? 0 : most; };
  response->set_tenant(caller->tenant);
  for (const Scope scope : caller->scopes) response->add_scopes(std::string(ScopeName(scope)));
  response->set_max_open_jobs(bounded(caller->max_open_jobs));
  response->set_max_kept_jobs(bounded(caller->max_kept_jobs));
  response->set_max_kept_bytes(bounded(caller->max_kept_bytes));
  response->set_max_calls_per_second(caller->max_calls_per_second);
  response->set_max_jobs_per_second(caller->max_jobs_per_second);
  return grpc::Status::OK;
}

grpc::Status JobsService::GetUsage(grpc::ServerContext* context, const v1::GetUsageRequest* request,
                                   v1::Usage* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto tenant = TenantAskedFor(*caller, request->has_tenant(), request->tenant());
  if (!tenant.ok()) return rpc::ToGrpc(tenant.status());
  // The method reads all data of the tenant, so the number of such calls is limited.
  const auto slot = lists_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  const auto usage = UsageOf(*tenant, backend_.jobs, backend_.blobs);
  if (usage.ok()) *response = *usage;
  return rpc::ToGrpc(usage.status());
}

grpc::Status JobsService::ListArtifacts(grpc::ServerContext* context,
                                        const v1::ListArtifactsRequest* request,
                                        v1::ListArtifactsResponse* response) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto job = Find(*caller, request->id(), Of::kTenant);
  if (!job.ok()) return rpc::ToGrpc(job.status());
  // The method reads a program, so the number of such calls is limited.
  const auto slot = lists_of_tenants_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  const CancelScope scope(CancelToken([&] { return context->IsCancelled(); }));
  auto list = coordinator::ListArtifacts(*job, backend_.blobs, derived_facts_);
  if (list.ok()) *response = *std::move(list);
  return rpc::ToGrpc(list.status());
}

grpc::Status JobsService::WatchJobs(grpc::ServerContext* context,
                                    const v1::WatchJobsRequest* request,
                                    grpc::ServerWriter<v1::WatchJobsResponse>* stream) {
  const auto caller = backend_.callers.Find(*context, {Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  const auto tenant = TenantAskedFor(*caller, request->has_tenant(), request->tenant());
  if (!tenant.ok()) return rpc::ToGrpc(tenant.status());
  const auto from_us = WatchedFrom(*request, backend_.now_us());
  if (!from_us.ok()) return rpc::ToGrpc(from_us.status());
  const auto slot = watches_of_all_jobs_.Enter(caller->tenant);
  if (!slot.ok()) return rpc::ToGrpc(slot.status());
  TenantWatch watch(backend_.jobs, backend_.feed, backend_.now_us);
  // Otherwise a client could not distinguish an open watch from a dead server.
  context->AddInitialMetadata("slicefarm-watch", "open");
  stream->SendInitialMetadata();
  return rpc::ToGrpc(watch.Run({backend_.jobs, *tenant, *from_us}, *context, *stream));
}

grpc::Status JobsService::ListSettings(grpc::ServerContext* context,
                                       const v1::ListSettingsRequest* request,
                                       v1::ListSettingsResponse* response) {
  const auto caller =
      backend_.callers.Find(*context, {Scope::kSubmit, Scope::kRead, Scope::kAdmin});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  Process process = kDefaultProcess;
  if (request->process() != v1::PROCESS_UNSPECIFIED) {
    const auto known = EnumFromProto<Process>(request->process(), kProcessCount, "process");
    if (!known.ok()) return rpc::ToGrpc(known.status());
    process = *known;
  }
  for (const config::SettingSpec& spec : config::SettingsTable(process))
    *response->add_settings() = ToProto(spec);
  return grpc::Status::OK;
}

}  // namespace slicefarm::coordinator
