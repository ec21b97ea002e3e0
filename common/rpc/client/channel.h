#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/security/credentials.h>

#include <cstdint>
#include <memory>
#include <string>

#include "common/model/limits.h"

namespace slicefarm::rpc {

struct ChannelOptions {
  int64_t max_message_bytes = limits::kMaxStageMessageBytes;
  bool retries = true;          ///< of unary methods; without, each call is one attempt
  bool own_connection = false;  ///< else channels to the same address share theirs
  std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr;  ///< null: no TLS
  /// What the server's certificate must say instead of the address's host, if not empty.
  std::string server_name = {};
  std::string token = {};  ///< goes along with each call as `authorization: Bearer`, if not empty
};

/// A channel to one address (host:port): keepalive that notices a dead peer within half a minute,
/// reconnection within a second, and, for unary methods, up to three retries while the server is
/// UNAVAILABLE (unless the options say otherwise). No proxy. Connects when first used.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options = {});

}  // namespace slicefarm::rpc
