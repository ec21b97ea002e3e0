#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/client/client_call.h"

namespace slicefarm::rpc {

/// Calls grpc.health.v1.Health and returns true if a server, or one service of the server, is
/// SERVING. `service`: name of the service; empty for the whole server. Errors: any error of the
/// call; NotFound if the server does not have the service.
absl::StatusOr<bool> IsServing(const std::shared_ptr<grpc::Channel>& channel,
                               const std::string& service, const ClientCallOptions& options);

/// Name of a health service that is SERVING as long as the server runs, even while the health of
/// the whole server is NOT_SERVING.
inline constexpr char kLiveService[] = "live";

/// Returns the name of a health service that only servers of this build (build_info.h) have.
/// Callers check that it is SERVING before they give work to a server.
std::string ServiceOfThisBuild();

}  // namespace slicefarm::rpc
