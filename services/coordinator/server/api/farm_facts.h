#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/table/settings_table.h"
#include "services/coordinator/algo/dispatch/task_executor.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the tenant to which a request applies. `asked`: the request names `tenant`; else it is
/// the caller's own tenant. Errors: PERMISSION_DENIED if another tenant is named and the caller is
/// no administrator.
absl::StatusOr<std::string> TenantAskedFor(const Caller& caller, bool asked,
                                           const std::string& tenant);

/// Returns the amount of data that the farm stores for a tenant: numbers of jobs, and bytes. Cost:
/// reads the lists of its jobs and blobs. Errors: see JobStore and BlobStore.
absl::StatusOr<v1::Usage> UsageOf(const std::string& tenant, JobStore& jobs, BlobStores& blobs);

/// Marks an open job as waiting if no connected worker supports its process, or if a stage that it
/// needs has no reachable server (`away_stages`: their names). Removes its expected end, because
/// the end is unknown then.
void DescribeWaiting(const TaskExecutor& executor,
                     const std::function<std::vector<std::string>(Process)>& away_stages,
                     v1::Job& job);

/// Converts the description of a setting.
v1::ListSettingsResponse::Info ToProto(const config::SettingSpec& spec);

}  // namespace slicefarm::coordinator
