#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::exposure {

/// Returns the gRPC service slicefarm.v1.Exposure on top of an ExposureStage. `stage`, `gate` and
/// `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeExposureService(const ExposureStage& stage,
                                                   rpc::CallLimiter& gate, SharedCache& shared);

}  // namespace slicefarm::exposure
