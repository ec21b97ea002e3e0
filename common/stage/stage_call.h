#pragma once

#include <string>

#include "common/base/cancel_token.h"
#include "common/base/trace_context.h"

namespace slicefarm {

class JobMemory;
class SpanLog;

/// Tenant and priority of a job, for fair sharing.
struct Claimant {
  std::string tenant;
  int priority = 0;  ///< priority among the tenant's own jobs; greater values first
};

/// Context of a call of a stage.
struct StageCall {
  std::string job_id;  ///< id of the job, for logs
  Claimant claimant = {};
  CancelToken cancel;
  int threads = 1;           ///< number of threads that a stage may use; never changes the result
  TraceContext trace = {};   ///< trace context, passed on with each call; empty: none
  SpanLog* spans = nullptr;  ///< log of timed spans in this process; null: none
  JobMemory* memory = nullptr;  ///< memory account of the job in this process; null: not counted
};

}  // namespace slicefarm
