#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_limiter.h"

namespace slicefarm::planning {

/// Returns the gRPC service slicefarm.v1.Planning, which calls a JobPlanner. Layers are planned as
/// they arrive, and their plans are sent as soon as they are finished. Only the data of the
/// planners stays in memory. `gate` must outlive the service.
std::unique_ptr<grpc::Service> MakePlanningService(rpc::CallLimiter& gate);

}  // namespace slicefarm::planning
