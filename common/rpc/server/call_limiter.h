#pragma once

#include <grpcpp/server_context.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"
#include "common/base/trace_context.h"
#include "common/model/layers/layer.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/admission.h"
#include "common/rpc/server/call_scope.h"

namespace slicefarm::rpc {

/// Slots, queue length and time limits of a CallLimiter.
struct CallLimiterOptions {
  int slots = 1;  ///< number of calls that work at the same time
  int queue = 8;  ///< number of calls that wait; further calls are refused with OVERLOADED
  /// Deadline of calls for which the client has set none.
  std::chrono::milliseconds default_deadline{300'000};
  /// time limit of every call, even if its client has set a later deadline
  std::chrono::milliseconds longest = CallScope::kNoLimit;
};

/// Properties of a call for its handler. The handler sets job_id, layers and `about` for the log.
struct Call {
  CancelToken cancel;  ///< cancelled by the client or at the deadline
  TraceContext trace;  ///< trace that the client sent
  std::string job_id;
  LayerRange layers;  ///< layers of the call, for the log; empty: the call concerns no layers
  LogFields about;    ///< further fields of the log line
};

/// Runs every call with heavy work in the same steps: wait for a slot, work, log one line, return
/// the status. Thread-safe.
class CallLimiter {
 public:
  CallLimiter(const CallLimiterOptions& options, JsonLog log);

  /// Waits for a slot, calls `work`, logs the call, and returns its status for gRPC.
  grpc::Status Run(const grpc::ServerContext& context, std::string_view method,
                   const std::function<absl::Status(Call&)>& work);

  const Admission& admission() const { return admission_; }

 private:
  void Log(std::string_view method, const Call& call, double seconds,
           const absl::Status& status) const;

  const CallLimiterOptions options_;
  const JsonLog log_;
  Admission admission_;
};

}  // namespace slicefarm::rpc
