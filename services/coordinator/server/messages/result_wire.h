#pragma once

#include "services/coordinator/store/jobs/job_record.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Converts the cost of a job.
v1::Cost ToProto(const Cost& cost);

/// Converts a result without its shares.
v1::JobResult ToProto(const JobResult& result);

/// Adds the shares of a result with their costs; nothing if the result has none.
void AddShares(const JobResult& result, v1::JobResult& proto);

}  // namespace slicefarm::coordinator
