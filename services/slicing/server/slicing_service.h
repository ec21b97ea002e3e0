#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/rpc/server/call_limiter.h"
#include "common/stage/memory_budget.h"
#include "common/stage/plates.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/slicing/server/project_reading.h"

namespace slicefarm::slicing {

/// Returns the gRPC service slicefarm.v1.Slicing, which calls a SlicingStage, an ArrangingStage, a
/// PlacingStage and `projects`. The stages, `gate` and `memory` must outlive the service.
/// `threads`: number of threads that one call may use; `memory`: memory that all calls together may
/// use.
std::unique_ptr<grpc::Service> MakeSlicingService(const SlicingStage& slicing,
                                                  const ArrangingStage& arranging,
                                                  const PlacingStage& placing,
                                                  ReadProjects projects, rpc::CallLimiter& gate,
                                                  int threads, MemoryBudget& memory);

}  // namespace slicefarm::slicing
