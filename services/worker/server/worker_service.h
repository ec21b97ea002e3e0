#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_gate.h"
#include "common/stage/task.h"

namespace slicefarm::worker {

/// Translates slicefarm.v1.Worker to a TaskRunner and back. The gate's slots are the worker's.
/// `shared`: what the jobs' tasks have in common. All three must outlive the service.
std::unique_ptr<grpc::Service> MakeWorkerService(const TaskRunner& runner, rpc::CallGate& gate,
                                                 SharedCache& shared);

}  // namespace slicefarm::worker
