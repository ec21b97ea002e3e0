#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <chrono>
#include <string>

#include "prometheus/counter.h"
#include "prometheus/family.h"
#include "prometheus/histogram.h"
#include "prometheus/registry.h"

namespace slicefarm::rpc {

/// Metrics of a server's calls, with the usual names for gRPC:
///   grpc_server_started_total{grpc_service,grpc_method}
///   grpc_server_handled_total{grpc_service,grpc_method,grpc_code}
///   grpc_server_handling_seconds{grpc_service,grpc_method}
/// The registry must outlive this object. This object must outlive the servers that report calls to
/// it. Thread-safe.
class CallMetrics {
 public:
  /// REQUIRES: `registry` outlives this object.
  explicit CallMetrics(prometheus::Registry& registry);

  /// Counts the start of a call. `method`: in gRPC's form, "/slicefarm.v1.Beading/BeadLayers".
  void Started(const std::string& method);
  /// Counts the end of a call with its status and duration.
  void Handled(const std::string& method, grpc::StatusCode code,
               std::chrono::duration<double> time);

 private:
  prometheus::Family<prometheus::Counter>& started_;
  prometheus::Family<prometheus::Counter>& handled_;
  prometheus::Family<prometheus::Histogram>& handling_seconds_;
};

/// Interceptor factory that reports each call of a server to CallMetrics. Methods that are not in
/// this program's protos are counted under the name "unknown", so that callers cannot create any
/// number of labels.
class CallMetricsFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  explicit CallMetricsFactory(CallMetrics& metrics) : metrics_(metrics) {}
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  CallMetrics& metrics_;
};

/// Returns the name of a status code: "OK", "INVALID_ARGUMENT", ...
std::string CodeName(grpc::StatusCode code);

}  // namespace slicefarm::rpc
