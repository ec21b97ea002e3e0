#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_gate.h"
#include "common/stage/stages.h"

namespace slicefarm::exposure {

/// Translates slicefarm.v1.Exposure to an ExposureStage and back.
/// `stage` and `gate` must outlive the service.
std::unique_ptr<grpc::Service> MakeExposureService(const ExposureStage& stage, rpc::CallGate& gate);

}  // namespace slicefarm::exposure
