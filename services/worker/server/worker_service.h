#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/shared/shared_cache.h"
#include "common/rpc/server/call_limiter.h"
#include "common/stage/task.h"

namespace slicefarm::worker {

/// Returns the service slicefarm.v1.Worker, which passes its calls to a TaskRunner. The slots of
/// the gate are the slots of the worker. `shared`: cache of the values that the tasks of a job
/// share. The runner, the gate and `shared` must outlive the service.
std::unique_ptr<grpc::Service> MakeWorkerService(const TaskRunner& runner, rpc::CallLimiter& gate,
                                                 SharedCache& shared);

}  // namespace slicefarm::worker
