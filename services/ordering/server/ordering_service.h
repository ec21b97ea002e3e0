#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::ordering {

/// Returns the gRPC service slicefarm.v1.Ordering on top of an OrderingStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeOrderingService(const OrderingStage& stage,
                                                   rpc::CallLimiter& gate, SharedCache& shared);

}  // namespace slicefarm::ordering
