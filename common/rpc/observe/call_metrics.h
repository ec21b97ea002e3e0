#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <chrono>
#include <string>

#include "prometheus/counter.h"
#include "prometheus/family.h"
#include "prometheus/histogram.h"
#include "prometheus/registry.h"

namespace slicefarm::rpc {

/// What a server's calls come to, by the names of the gRPC ecosystem:
///   grpc_server_started_total{grpc_service,grpc_method}
///   grpc_server_handled_total{grpc_service,grpc_method,grpc_code}
///   grpc_server_handling_seconds{grpc_service,grpc_method}
/// The registry must outlive it; it must outlive the servers whose calls it counts. Thread-safe.
class CallMetrics {
 public:
  explicit CallMetrics(prometheus::Registry& registry);

  /// `method`: as gRPC has it, "/slicefarm.v1.Beading/BeadLayers".
  void Started(const std::string& method);
  void Handled(const std::string& method, grpc::StatusCode code,
               std::chrono::duration<double> time);

 private:
  prometheus::Family<prometheus::Counter>& started_;
  prometheus::Family<prometheus::Counter>& handled_;
  prometheus::Family<prometheus::Histogram>& handling_seconds_;
};

/// Tells CallMetrics of each call of a server. Methods that are not in this program's protos count
/// as "unknown": whatever strangers call, the number of labels is bounded.
class CallMetricsFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  explicit CallMetricsFactory(CallMetrics& metrics) : metrics_(metrics) {}
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  CallMetrics& metrics_;
};

/// "OK", "INVALID_ARGUMENT", ...
std::string CodeName(grpc::StatusCode code);

}  // namespace slicefarm::rpc
