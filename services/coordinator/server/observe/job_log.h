#pragma once

#include "common/base/trace_context.h"
#include "common/rpc/observe/json_log.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Returns the trace that a job belongs to: the trace of the call that created it, or its own
/// trace. All coordinators and all runs use the same trace.
TraceContext TraceOf(const JobRecord& job);

/// Returns the fields of each log line about a job: job, tenant and trace.
rpc::LogFields FieldsOf(const JobRecord& job);

}  // namespace slicefarm::coordinator
