#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_limiter.h"

namespace slicefarm::planning {

/// Translates slicefarm.v1.Planning to a JobPlanner and back. Layers are planned as they arrive,
/// and their plans are sent at once. Only the data that the planners keep stays in memory.
/// `gate` must outlive the service.
std::unique_ptr<grpc::Service> MakePlanningService(rpc::CallLimiter& gate);

}  // namespace slicefarm::planning
