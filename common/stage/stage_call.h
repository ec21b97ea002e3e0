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
  int threads = 1;              ///< how many a stage may use; never changes the result
  TraceContext trace = {};      ///< travels on with each call; empty: none
  SpanLog* spans = nullptr;     ///< notes what is done when, in this process; null: nobody asks
  JobMemory* memory = nullptr;  ///< what the job holds in this process; null: nobody counts
};

}  // namespace slicefarm
