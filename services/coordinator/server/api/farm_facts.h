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

/// The tenant that a request names, if the caller may look at it; else his own. Errors:
/// PERMISSION_DENIED.
absl::StatusOr<std::string> TenantAskedFor(const Caller& caller, bool asked,
                                           const std::string& tenant);

/// What the farm keeps for a tenant. Cost: reads the lists of its jobs and blobs. Errors: the
/// stores'.
absl::StatusOr<v1::Usage> UsageOf(const std::string& tenant, JobStore& jobs, BlobStores& blobs);

/// Says of a job that has not ended if no worker is there for it; its end cannot be expected then.
void TellWaiting(const TaskExecutor& executor, v1::Job& job);

v1::ListSettingsResponse::Info ToProto(const config::SettingSpec& spec);

}  // namespace slicefarm::coordinator
