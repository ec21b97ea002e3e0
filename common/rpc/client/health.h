#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/client_call.h"

namespace slicefarm::rpc {

/// Calls grpc.health.v1.Health and returns true if a server, or one service of it, is serving.
/// `service`: empty for the server as a whole. Errors: errors of the call; NotFound if the server
/// does not have the service.
absl::StatusOr<bool> IsServing(const std::shared_ptr<grpc::Channel>& channel,
                               const std::string& service, const ClientCallOptions& options);

/// Name of a health service that is SERVING as long as a server runs, even while the server as a
/// whole is not ready.
inline constexpr char kLiveService[] = "live";

/// Returns the name of the health service that only servers of this build have. Callers check its
/// health before they give work to a server.
std::string ServiceOfThisBuild();

}  // namespace slicefarm::rpc
