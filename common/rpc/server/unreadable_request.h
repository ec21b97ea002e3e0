#pragma once

#include <grpcpp/support/server_interceptor.h>

namespace slicefarm::rpc {

/// Interceptor factory that adds a reason to the error of a request that gRPC cannot read: bytes
/// that are not a message of the method, or a text that is not UTF-8. gRPC's error is only
/// INTERNAL; the client receives REQUEST_MALFORMED. Errors of slicefarm have details and are not
/// changed.
class UnreadableRequestFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;
};

}  // namespace slicefarm::rpc
