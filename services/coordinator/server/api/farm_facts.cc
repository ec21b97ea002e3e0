#include "services/coordinator/server/api/farm_facts.h"

#include "common/base/error.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::string> TenantAskedFor(const Caller& caller, bool asked,
                                           const std::string& tenant) {
  if (!asked || tenant == caller.tenant) return caller.tenant;
  if (caller.may(Scope::kAdmin)) return tenant;
  return MakeError(absl::StatusCode::kPermissionDenied, Reason::kPermissionDenied,
                   "another tenant is for administrators",
                   {{"scope", std::string(ScopeName(Scope::kAdmin))}});
}

absl::StatusOr<v1::Usage> UsageOf(const std::string& tenant, JobStore& jobs, BlobStores& blobs) {
  const auto kept = jobs.CountOf(tenant);
  if (!kept.ok()) return kept.status();
  const auto open = jobs.CountOpenOf(tenant);
  if (!open.ok()) return open.status();
  const auto store = blobs.Of(tenant);
  if (!store.ok()) return store.status();
  const auto bytes = (*store)->KeptBytes();
  if (!bytes.ok()) return bytes.status();
  v1::Usage usage;
  usage.set_tenant(tenant);
  usage.set_kept_jobs(*kept);
  usage.set_kept_bytes(*bytes);
  for (const auto& [state, count] : *open)
    state == JobState::kQueued ? usage.set_queued_jobs(count) : usage.set_running_jobs(count);
  return usage;
}

v1::ListSettingsResponse::Info ToProto(const config::SettingSpec& spec) {
  v1::ListSettingsResponse::Info info;
  info.set_key(std::string(spec.key));
  info.set_description(std::string(spec.doc));
  info.set_default_value(std::string(spec.standard));
  info.set_range(config::DescribeRange(spec));
  info.set_unit(std::string(spec.unit));
  return info;
}

}  // namespace slicefarm::coordinator
