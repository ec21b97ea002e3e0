#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/motion_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::motion {

/// Translates slicefarm.v1.Motion to a MotionStage and back.
/// `stage`, `gate` and `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeMotionService(const MotionStage& stage, rpc::CallLimiter& gate,
                                                 SharedCache& shared);

}  // namespace slicefarm::motion
