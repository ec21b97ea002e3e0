#pragma once

#include <grpcpp/support/server_interceptor.h>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/server/api/callers.h"

namespace slicefarm::coordinator {

/// Writes an audit log: at least one line for each call that changes or exports data of a tenant:
///
///   {"msg":"audit","method":"/slicefarm.v1.Jobs/CancelJob","tenant":"acme","token":"1f0c5a9be3d2",
///    "address":"ipv4:192.0.2.7:40000","objects":"0123...","code":"OK"}
///
/// `token` and `certificate` have the first 12 digits of a SHA-256; a line has one of them or both.
/// `objects` has the ids and names in the request and in the answer, separated by blanks. A line
/// has at most 50 of them; a call with more gets more lines, with the same other fields. Refused
/// calls get a line as well, with their `reason`. One factory serves all calls of a server.
class AuditLogFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  /// Writes to `log`. `callers` must outlive the factory.
  AuditLogFactory(const Callers& callers, rpc::JsonLog log)
      : callers_(callers), log_(std::move(log)) {}

  /// Returns the interceptor of a call; null for a method that neither changes nor exports data.
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const Callers& callers_;
  const rpc::JsonLog log_;
};

}  // namespace slicefarm::coordinator
