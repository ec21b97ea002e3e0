#include "common/rpc/server/call_limiter.h"

#include <utility>

#include "common/base/error.h"
#include "common/rpc/observe/trace_metadata.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::rpc {

CallLimiter::CallLimiter(const CallLimiterOptions& options, JsonLog log)
    : options_(options), log_(std::move(log)), admission_(options.slots, options.queue) {}

grpc::Status CallLimiter::Run(const grpc::ServerContext& context, std::string_view method,
                              const std::function<absl::Status(Call&)>& work) {
  const auto start = CallScope::Clock::now();
  const CallScope scope(context, options_.default_deadline, options_.longest);
  Call call;
  call.cancel = scope.Token();
  call.trace = TraceOf(context);
  const absl::StatusOr<Admission::Ticket> turn = admission_.Enter(call.cancel);
  const absl::Status status = scope.Outcome(turn.ok() ? work(call) : turn.status());
  const std::chrono::duration<double> time = CallScope::Clock::now() - start;
  Log(method, call, time.count(), status);
  return ToGrpc(status);
}

void CallLimiter::Log(std::string_view method, const Call& call, double seconds,
                      const absl::Status& status) const {
  LogFields fields = {{"method", std::string(method)}, {"job", call.job_id}};
  AddTrace(call.trace, &fields);
  if (!call.layers.empty()) {
    fields.push_back({"layer_first", int64_t{call.layers.first}});
    fields.push_back({"layer_last", int64_t{call.layers.last - 1}});
  }
  fields.insert(fields.end(), call.about.begin(), call.about.end());
  fields.push_back({"seconds", seconds});
  if (status.ok()) return log_.Info("call", fields);
  fields.push_back({"code", absl::StatusCodeToString(status.code())});
  fields.push_back({"reason", std::string(ReasonName(DetailOf(status).reason))});
  fields.push_back({"error", std::string(status.message())});
  if (DetailOf(status).reason == Reason::kSharedMissing) return log_.Info("call", fields);
  log_.Warn("call failed", fields);
}

}  // namespace slicefarm::rpc
