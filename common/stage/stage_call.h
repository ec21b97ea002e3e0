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
  /// priority among the jobs of the same tenant; a job with a greater value is first
  int priority = 0;
};

/// Context of a call of a stage.
struct StageCall {
  std::string job_id;  ///< id of the job, for logs
  Claimant claimant = {};
  CancelToken cancel;
  int threads = 1;           ///< number of threads that a stage may use; does not change the result
  TraceContext trace = {};   ///< trace context, passed on with each call; empty: none
  SpanLog* spans = nullptr;  ///< log for spans of time in this program; null: none
  JobMemory* memory = nullptr;  ///< memory account of the job in this program; null: not counted
};

}  // namespace slicefarm
