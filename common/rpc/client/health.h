#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/client_call.h"

namespace slicefarm::rpc {

/// Asks grpc.health.v1.Health whether a server, or one service of it, is serving. `service`: empty
/// for the server as a whole. Errors: those of the call; NotFound for a service it does not have.
absl::StatusOr<bool> IsServing(const std::shared_ptr<grpc::Channel>& channel,
                               const std::string& service, const ClientCallOptions& options);

/// The service that serves for as long as a server runs, also while the server as a whole is not
/// ready.
inline constexpr char kLiveService[] = "live";

/// The service that servers of this build have, and no others: what they are asked by, before they
/// are given work.
std::string ServiceOfThisBuild();

}  // namespace slicefarm::rpc
