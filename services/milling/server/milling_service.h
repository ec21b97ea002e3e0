#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/milling_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::milling {

/// Returns the gRPC service slicefarm.v1.Milling, which calls a MillingStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeMillingService(const MillingStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared);

}  // namespace slicefarm::milling
