#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_gate.h"
#include "common/stage/task.h"

namespace slicefarm::worker {

/// Translates slicefarm.v1.Worker to a TaskRunner and back. The gate's slots are the worker's.
/// `runner` and `gate` must outlive the service.
std::unique_ptr<grpc::Service> MakeWorkerService(const TaskRunner& runner, rpc::CallGate& gate);

}  // namespace slicefarm::worker
