#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/beading_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::beading {

/// Returns the gRPC service slicefarm.v1.Beading, which calls a BeadingStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeBeadingService(const BeadingStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared);

}  // namespace slicefarm::beading
