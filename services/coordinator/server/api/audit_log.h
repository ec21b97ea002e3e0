#pragma once

#include <grpcpp/support/server_interceptor.h>

#include "common/rpc/observe/json_log.h"
#include "services/coordinator/server/api/callers.h"

namespace slicefarm::coordinator {

/// Writes who did what: for each call that changes or hands out something of a tenant a line
///
///   {"msg":"audit","method":"/slicefarm.v1.Jobs/CancelJob","tenant":"acme","token":"1f0c5a9be3d2",
///    "address":"ipv4:192.0.2.7:40000","objects":"0123...","code":"OK"}
///
/// with the first 12 digits of the SHA-256 of the token, the certificate (`certificate`), or both;
/// `objects`: the ids and names in the request and the ids in the answer, 50 a line. Of calls that
/// were refused as well, with their `reason`. One for all calls of a server.
class AuditLogFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  /// `callers` outlives it.
  AuditLogFactory(const Callers& callers, rpc::JsonLog log)
      : callers_(callers), log_(std::move(log)) {}

  /// Null for a method that changes nothing.
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const Callers& callers_;
  const rpc::JsonLog log_;
};

}  // namespace slicefarm::coordinator
