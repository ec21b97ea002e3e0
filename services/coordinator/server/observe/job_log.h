#pragma once

#include "common/base/trace_context.h"
#include "common/rpc/observe/json_log.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// The trace that a job belongs to: that of the call which made it, or one of its own. The same for
/// every coordinator and every run.
TraceContext TraceOf(const JobRecord& job);

/// What each log line about a job says of it: job, tenant, trace.
rpc::LogFields FieldsOf(const JobRecord& job);

}  // namespace slicefarm::coordinator
