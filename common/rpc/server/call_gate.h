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

struct CallGateOptions {
  int slots = 1;  ///< calls at work at once
  int queue = 8;  ///< calls that wait for their turn; more are refused with OVERLOADED
  std::chrono::milliseconds default_deadline{300'000};      ///< where the client sent none
  std::chrono::milliseconds longest = CallScope::kNoLimit;  ///< whatever the client sent
};

/// A call as its handler sees it; what the handler learns of it goes to the log.
struct Call {
  CancelToken cancel;  ///< also asks whether the deadline has passed
  TraceContext trace;  ///< what the client gave
  std::string job_id;
  LayerRange layers;  ///< empty: the call is about no layers
  LogFields about;    ///< what else it is about
};

/// The way of every heavy call: wait for a turn, work, log one line, answer with a typed status.
/// Thread-safe.
class CallGate {
 public:
  CallGate(const CallGateOptions& options, JsonLog log);

  grpc::Status Run(const grpc::ServerContext& context, std::string_view method,
                   const std::function<absl::Status(Call&)>& work);

  const Admission& admission() const { return admission_; }

 private:
  void Log(std::string_view method, const Call& call, double seconds,
           const absl::Status& status) const;

  const CallGateOptions options_;
  const JsonLog log_;
  Admission admission_;
};

}  // namespace slicefarm::rpc
