#pragma once

#include <grpcpp/support/server_interceptor.h>

namespace slicefarm::rpc {

/// Gives a reason to calls whose request gRPC could not read, bytes that are no message of the
/// method or a text that is not UTF-8: REQUEST_MALFORMED, where gRPC says INTERNAL and no more.
/// Our own errors have details and pass.
class UnreadableRequestFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;
};

}  // namespace slicefarm::rpc
