#pragma once

#include <grpcpp/channel.h>

#include <cstdint>
#include <memory>
#include <string>

#include "common/model/limits.h"

namespace slicefarm::rpc {

struct ChannelOptions {
  int64_t max_message_bytes = limits::kMaxStageMessageBytes;
  bool retries = true;          ///< of unary methods; without, each call is one attempt
  bool own_connection = false;  ///< else channels to the same address share theirs
};

/// A channel to one address (host:port): keepalive that notices a dead peer within half a minute,
/// reconnection within a second, and, for unary methods, up to three retries while the server is
/// UNAVAILABLE (unless the options say otherwise). No proxy. Connects when first used.
std::shared_ptr<grpc::Channel> MakeChannel(const std::string& address,
                                           const ChannelOptions& options = {});

}  // namespace slicefarm::rpc
