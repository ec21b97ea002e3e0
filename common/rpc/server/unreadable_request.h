#pragma once

#include <grpcpp/support/server_interceptor.h>

namespace slicefarm::rpc {

/// Adds a reason to the error of a call with a request that gRPC cannot read: bytes that are not a
/// message of the method, or a text that is not UTF-8. Without it, the error would only be
/// INTERNAL; with it, the error is REQUEST_MALFORMED. Errors of slicefarm have details and are not
/// changed.
class UnreadableRequestFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;
};

}  // namespace slicefarm::rpc
