#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/client_interceptor.h>

#include <optional>
#include <string>

namespace slicefarm::rpc {

// Token in a call's metadata, `authorization: Bearer TOKEN` (RFC 6750).

/// Interceptor factory of a channel: sends a token with each call. gRPC's call credentials can do
/// this only over TLS, and connections on the loopback address may have no TLS.
class BearerTokenFactory : public grpc::experimental::ClientInterceptorFactoryInterface {
 public:
  explicit BearerTokenFactory(std::string token) : token_(std::move(token)) {}
  grpc::experimental::Interceptor* CreateClientInterceptor(
      grpc::experimental::ClientRpcInfo* info) override;

 private:
  const std::string token_;
};

/// Returns the token of a call; nullopt if the call has no `authorization` metadata. Returns an
/// empty text if the metadata is no bearer token or occurs several times.
std::optional<std::string> BearerToken(const grpc::ServerContextBase& context);

}  // namespace slicefarm::rpc
