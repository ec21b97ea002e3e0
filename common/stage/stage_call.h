#pragma once

#include <string>

#include "common/base/cancel_token.h"
#include "common/base/trace_context.h"

namespace slicefarm {

class JobMemory;
class SpanLog;

/// Tenant and priority, for fair sharing.
struct Claimant {
  std::string tenant;
  int priority = 0;  ///< greater ones first, among the tenant's own
};

struct StageCall {
  std::string job_id;  ///< for logs
  Claimant claimant = {};
  CancelToken cancel;
  int threads = 1;           ///< number of threads that a stage may use; never changes the result
  TraceContext trace = {};   ///< travels on with each call; empty: none
  SpanLog* spans = nullptr;  ///< log of timed spans in this process; null: none
  JobMemory* memory = nullptr;  ///< memory that the job holds in this process; null: not counted
};

}  // namespace slicefarm
