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
  bool retries = true;          ///< retries of unary methods; if false, each call is one attempt
  bool own_connection = false;  ///< if false, channels to the same address share a connection
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
  /// Name that the server's certificate must contain instead of the host of the address, if not
  /// empty.
  std::string server_name = {};
  std::string token = {};  ///< sent with each call as `authorization: Bearer`, if not empty
};

/// Returns a channel to one address (host:port). Its keepalive detects a dead peer within half a
/// minute, and it reconnects within a second. Unary methods have up to three retries while the
/// server is UNAVAILABLE, unless the options disable them. It does not use a proxy. It connects at
/// first use.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options = {});

}  // namespace slicefarm::rpc
