#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/server.h"
#include "common/rpc/server/shared_store.h"
#include "common/stage/beading_stage.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/memory_budget.h"
#include "common/stage/milling_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/task.h"
#include "common/stage/texture_stage.h"
#include "services/planning/server/planning_service.h"
#include "services/slicing/algo/placement/local_arranging_stage.h"
#include "services/slicing/algo/placement/local_placing_stage.h"

namespace slicefarm {

/// Stages of a host. All must outlive it.
struct HostedStages {
  const SlicingStage& slicing;
  const BeadingStage& beading;
  const InfillStage& infill;
  const OrderingStage& ordering;
  const MotionStage& motion;
  const TaskRunner& runner;
  /// Returns the planning service with this limit of calls. Planning is a service and not a stage
  /// class, because its algorithm is within the service.
  std::function<std::unique_ptr<grpc::Service>(rpc::CallLimiter&)> planning =
      planning::MakePlanningService;
  const ExposureStage* exposure = nullptr;  ///< null: the host has no such service
  const MillingStage* milling = nullptr;    ///< null: the host has no such service
  const TextureStage* texture = nullptr;    ///< null: the host has no such service
};

/// All services of the stages and the worker behind one real socket.
class StageHost {
 public:
  static constexpr int kThreads = 3;  ///< StageCall.threads in the slicing stage

  explicit StageHost(const HostedStages& stages, const rpc::CallLimiterOptions& gate = {4, 0},
                     const rpc::ServerOptions& options = {});

  std::string Address() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  rpc::Server& server() { return *server_; }
  const SharedCache& shared() { return keeper_.cache(); }

 private:
  rpc::Metrics metrics_;
  rpc::CallMetrics call_metrics_{metrics_.registry()};
  rpc::CallLimiter gate_;
  rpc::SharedStore keeper_;
  MemoryBudget memory_{int64_t{1} << 30};
  const std::unique_ptr<ArrangingStage> arranging_ = slicing::MakeLocalArranging();
  const std::unique_ptr<PlacingStage> placing_ = slicing::MakeLocalPlacing();
  std::vector<std::unique_ptr<grpc::Service>> services_;
  std::unique_ptr<rpc::Server> server_;
};

/// Returns a log that discards its lines.
rpc::JsonLog NoLog();

}  // namespace slicefarm
