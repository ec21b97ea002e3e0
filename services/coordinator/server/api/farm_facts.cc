#include "services/coordinator/server/api/farm_facts.h"

#include <fmt/core.h>

#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/model/process.h"
#include "common/wire/support/enum_wire.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::string> TenantAskedFor(const Caller& caller, bool asked,
                                           const std::string& tenant) {
  if (!asked || tenant == caller.tenant) return caller.tenant;
  if (caller.may(Scope::kAdmin)) return tenant;
  return MakeError(absl::StatusCode::kPermissionDenied, Reason::kPermissionDenied,
                   "only administrators may name another tenant",
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

void DescribeWaiting(const TaskExecutor& executor,
                     const std::function<std::vector<std::string>(Process)>& away_stages,
                     v1::Job& job) {
  if (job.state() != v1::JOB_STATE_QUEUED && job.state() != v1::JOB_STATE_RUNNING) return;
  const Process process = EnumFromProto<Process>(job.spec().process(), kProcessCount, "process")
                              .value_or(kDefaultProcess);
  std::string text;
  if (const std::vector<std::string> away = away_stages(process); !away.empty()) {
    text = fmt::format("the {} service: none can be reached", absl::StrJoin(away, " and the "));
  } else if (executor.Slots(process) == 0) {
    text = fmt::format("a worker: none that runs jobs of process {} is connected",
                       ProcessName(process));
    if (const std::string refusal = executor.Refusal(); !refusal.empty())
      text += fmt::format(". A worker is refused: {}", refusal);
  } else {
    return;
  }
  job.set_waits_for(text);
  job.clear_estimated_end_time();
}

v1::ListSettingsResponse::Info ToProto(const config::SettingSpec& spec) {
  v1::ListSettingsResponse::Info info;
  info.set_key(std::string(spec.key));
  info.set_description(std::string(spec.doc));
  info.set_default_value(std::string(spec.standard));
  info.set_range(config::DescribeRange(spec));
  info.set_unit(std::string(spec.unit));
  info.set_kind(std::string(config::KindName(spec.kind)));
  info.set_group(std::string(spec.group));
  const std::string_view place = config::ScopeName(spec.scope());
  info.set_scope(std::string(place.substr(place.find(' ') + 1)));
  for (const config::Choice& choice : spec.choices)
    if (choice.note.empty()) info.add_choices(std::string(choice.name));
  for (const config::Need* need : spec.needs) info.add_needs(std::string(need->what));
  if (spec.min < spec.max) {
    info.set_min(spec.min);
    info.set_max(spec.max);
  }
  return info;
}

}  // namespace slicefarm::coordinator
