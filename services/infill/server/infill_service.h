#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/infill_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::infill {

/// Returns the gRPC service slicefarm.v1.Infill, which calls an InfillStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeInfillService(const InfillStage& stage, rpc::CallLimiter& gate,
                                                 SharedCache& shared);

}  // namespace slicefarm::infill
