#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/security/credentials.h>

#include <cstdint>
#include <memory>
#include <string>

#include "common/model/limits.h"

namespace slicefarm::rpc {

/// Retries, connection sharing and security of a channel.
struct ChannelOptions {
  int64_t max_message_bytes = limits::kMaxStageMessageBytes;
  bool retries = true;  ///< true: gRPC retries unary methods; false: each call is one attempt
  bool own_connection = false;  ///< if false, channels to the same address share a connection
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
  /// If not empty: name that the server's certificate must contain instead of the host of the
  /// address.
  std::string server_name = {};
  std::string token = {};  ///< if not empty: token that each call sends as `authorization: Bearer`
};

/// Returns a channel to one address (host:port). It connects at its first use, without a proxy. A
/// dead peer is detected within half a minute by keepalive, and the channel reconnects within a
/// second. Unary methods have up to three retries while the server is UNAVAILABLE, unless the
/// options disable them.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options = {});

}  // namespace slicefarm::rpc
