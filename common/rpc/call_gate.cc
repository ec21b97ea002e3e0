#include "common/rpc/call_gate.h"

#include <utility>

#include "common/model/error.h"
#include "common/rpc/call_scope.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {

CallGate::CallGate(const CallGateOptions& options, JsonLog log)
    : options_(options), log_(std::move(log)), admission_(options.slots, options.queue) {}

grpc::Status CallGate::Run(const grpc::ServerContext& context, std::string_view method,
                           const std::function<absl::Status(Call&)>& work) {
  const auto start = CallScope::Clock::now();
  const CallScope scope(context, options_.default_deadline);
  Call call;
  call.cancel = scope.Token();
  const absl::StatusOr<Admission::Ticket> turn = admission_.Enter(call.cancel);
  const absl::Status status = scope.Outcome(turn.ok() ? work(call) : turn.status());
  const std::chrono::duration<double> time = CallScope::Clock::now() - start;
  Log(method, call, time.count(), status);
  return ToGrpc(status);
}

void CallGate::Log(std::string_view method, const Call& call, double seconds,
                   const absl::Status& status) const {
  const std::string name(method);
  if (status.ok()) {
    log_.Info("call", {{"method", name},
                       {"job", call.job_id},
                       {"layer_first", int64_t{call.layers.first}},
                       {"layer_last", int64_t{call.layers.last - 1}},
                       {"seconds", seconds}});
    return;
  }
  log_.Warn("call failed", {{"method", name},
                            {"job", call.job_id},
                            {"layer_first", int64_t{call.layers.first}},
                            {"layer_last", int64_t{call.layers.last - 1}},
                            {"seconds", seconds},
                            {"code", absl::StatusCodeToString(status.code())},
                            {"reason", std::string(ReasonName(DetailOf(status).reason))},
                            {"error", std::string(status.message())}});
}

}  // namespace slicefarm::rpc
