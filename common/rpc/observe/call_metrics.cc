#include "common/rpc/observe/call_metrics.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "absl/status/status.h"

namespace slicefarm::rpc {
namespace {

using Clock = std::chrono::steady_clock;

/// Returns the labels for "/package.Service/Method".
std::map<std::string, std::string> Labels(std::string_view method) {
  const size_t begin = method.starts_with('/') ? 1 : 0;
  const size_t slash = method.find('/', begin);
  if (slash == std::string_view::npos)
    return {{"grpc_service", ""}, {"grpc_method", std::string(method)}};
  return {{"grpc_service", std::string(method.substr(begin, slash - begin))},
          {"grpc_method", std::string(method.substr(slash + 1))}};
}

constexpr char kUnknown[] = "/unknown/unknown";

/// Returns true if a server can have the method. gRPC also reports calls of unknown methods to
/// interceptors, with the name that the client sent.
bool IsKnown(std::string_view method) {
  // gRPC's own health service has no descriptor in this program.
  if (method == "/grpc.health.v1.Health/Check" || method == "/grpc.health.v1.Health/Watch") {
    return true;
  }
  if (!method.starts_with('/')) return false;
  std::string name(method.substr(1));
  if (std::count(name.begin(), name.end(), '/') != 1) return false;
  std::replace(name.begin(), name.end(), '/', '.');
  return google::protobuf::DescriptorPool::generated_pool()->FindMethodByName(name) != nullptr;
}

/// Returns bucket limits from 1 ms to about a minute, with a factor of about 2.5 between them.
const prometheus::Histogram::BucketBoundaries& Buckets() {
  static const prometheus::Histogram::BucketBoundaries buckets = {
      0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 25, 60};
  return buckets;
}

class CallMetricsInterceptor : public grpc::experimental::Interceptor {
 public:
  CallMetricsInterceptor(CallMetrics& metrics, std::string method)
      : metrics_(metrics), method_(std::move(method)) {
    metrics_.Started(method_);
  }

  ~CallMetricsInterceptor() override { metrics_.Handled(method_, code_, Clock::now() - start_); }

  void Intercept(grpc::experimental::InterceptorBatchMethods* methods) override {
    using Hook = grpc::experimental::InterceptionHookPoints;
    if (methods->QueryInterceptionHookPoint(Hook::PRE_SEND_STATUS)) {
      code_ = methods->GetSendStatus().error_code();
    }
    methods->Proceed();
  }

 private:
  CallMetrics& metrics_;
  const std::string method_;
  const Clock::time_point start_ = Clock::now();
  grpc::StatusCode code_ = grpc::StatusCode::CANCELLED;  // for calls that end without a status
};

}  // namespace

std::string CodeName(grpc::StatusCode code) {
  return absl::StatusCodeToString(static_cast<absl::StatusCode>(code));
}

CallMetrics::CallMetrics(prometheus::Registry& registry)
    : started_(prometheus::BuildCounter()
                   .Name("grpc_server_started_total")
                   .Help("Received calls")
                   .Register(registry)),
      handled_(prometheus::BuildCounter()
                   .Name("grpc_server_handled_total")
                   .Help("Answered calls, by status code")
                   .Register(registry)),
      handling_seconds_(prometheus::BuildHistogram()
                            .Name("grpc_server_handling_seconds")
                            .Help("Time from receiving a call to its answer")
                            .Register(registry)) {}

void CallMetrics::Started(const std::string& method) { started_.Add(Labels(method)).Increment(); }

void CallMetrics::Handled(const std::string& method, grpc::StatusCode code,
                          std::chrono::duration<double> time) {
  std::map<std::string, std::string> labels = Labels(method);
  handling_seconds_.Add(labels, Buckets()).Observe(time.count());
  labels["grpc_code"] = CodeName(code);
  handled_.Add(labels).Increment();
}

grpc::experimental::Interceptor* CallMetricsFactory::CreateServerInterceptor(
    grpc::experimental::ServerRpcInfo* info) {
  const char* method = info->method();
  return new CallMetricsInterceptor(metrics_, IsKnown(method) ? method : kUnknown);  // gRPC owns it
}

}  // namespace slicefarm::rpc
