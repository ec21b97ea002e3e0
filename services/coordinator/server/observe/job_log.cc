#include "services/coordinator/server/observe/job_log.h"

namespace slicefarm::coordinator {

TraceContext TraceOf(const JobRecord& job) {
  return ParseTraceparent(job.traceparent).value_or(TraceOfJob(job.id));
}

rpc::LogFields FieldsOf(const JobRecord& job) {
  rpc::LogFields fields = {{"job", job.id}};
  if (!job.tenant.empty()) fields.push_back({"tenant", job.tenant});
  rpc::AddTrace(TraceOf(job), &fields);
  return fields;
}

}  // namespace slicefarm::coordinator
