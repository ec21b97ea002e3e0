#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/client_interceptor.h>

#include <optional>
#include <string>

namespace slicefarm::rpc {

/// A token in a call's metadata, `authorization: Bearer TOKEN` (RFC 6750).

/// Sends one along with each call of a channel. gRPC's own call credentials would do, but not
/// without TLS, which loopback connections need not have.
class BearerTokenFactory : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit BearerTokenFactory(std::string token) : token_(std::move(token)) {}
  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo* info) override;

 private:
  const std::string token_;
};

/// The token of a call. nullopt: there is no such metadata; empty: it is not a bearer's, or there
/// are several.
std::optional<std::string> BearerToken(const grpc::ServerContextBase& context);

}  // namespace slicefarm::rpc
