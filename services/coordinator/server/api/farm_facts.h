#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/config/table/settings_table.h"
#include "services/coordinator/algo/dispatch/task_executor.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the tenant that a request names, if the caller may access it. Returns the caller's own
/// tenant if the request names none. Errors: PERMISSION_DENIED.
absl::StatusOr<std::string> TenantAskedFor(const Caller& caller, bool asked,
                                           const std::string& tenant);

/// Returns the data that the farm stores for a tenant: numbers of jobs, and bytes. Cost: reads the
/// lists of its jobs and blobs. Errors: errors of the stores.
absl::StatusOr<v1::Usage> UsageOf(const std::string& tenant, JobStore& jobs, BlobStores& blobs);

/// Marks an open job as waiting if no connected worker supports its process. Its expected end is
/// removed, because it is unknown in this case.
void TellWaiting(const TaskExecutor& executor, v1::Job& job);

/// Converts the description of a setting.
v1::ListSettingsResponse::Info ToProto(const config::SettingSpec& spec);

}  // namespace slicefarm::coordinator
