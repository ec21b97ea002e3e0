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
  /// true: the channel has a connection of its own; false: channels to the same address share one
  bool own_connection = false;
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
  /// Name that the server's certificate must contain; empty: the host of the address.
  std::string server_name = {};
  std::string token = {};  ///< token that each call sends as `authorization: Bearer`; empty: none
};

/// Returns a channel to one address (host:port). The channel connects at its first call, without a
/// proxy. Keepalive detects a dead peer within half a minute, and the channel reconnects within a
/// second. Unary methods have up to three retries while the server is UNAVAILABLE, unless the
/// options disable them.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options = {});

}  // namespace slicefarm::rpc
