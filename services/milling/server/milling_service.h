#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_gate.h"
#include "common/stage/stages.h"

namespace slicefarm::milling {

/// Translates slicefarm.v1.Milling to a MillingStage and back.
/// `stage` and `gate` must outlive the service.
std::unique_ptr<grpc::Service> MakeMillingService(const MillingStage& stage, rpc::CallGate& gate);

}  // namespace slicefarm::milling
