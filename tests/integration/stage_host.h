#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/call_gate.h"
#include "common/rpc/server/server.h"
#include "common/stage/task.h"
#include "services/beading/server/beading_service.h"
#include "services/exposure/server/exposure_service.h"
#include "services/infill/server/infill_service.h"
#include "services/motion/server/motion_service.h"
#include "services/ordering/server/ordering_service.h"
#include "services/planning/server/planning_service.h"
#include "services/slicing/algo/placement/arranging/local_arranging_stage.h"
#include "services/slicing/server/slicing_service.h"
#include "services/worker/server/worker_service.h"

namespace slicefarm {

/// The stages that a host serves; all must outlive it.
struct HostedStages {
  const SlicingStage& slicing;
  const BeadingStage& beading;
  const InfillStage& infill;
  const OrderingStage& ordering;
  const MotionStage& motion;
  const TaskRunner& runner;
  /// Planning has its algorithm within its service.
  std::function<std::unique_ptr<v1::Planning::Service>(rpc::CallGate&)> planning =
      [](rpc::CallGate& gate) { return std::make_unique<planning::PlanningService>(gate); };
  const ExposureStage* exposure = nullptr;  ///< null: it is not served
};

/// All services of the stages and the worker behind one real socket.
class StageHost {
 public:
  static constexpr int kThreads = 3;  ///< StageCall.threads as the slicing stage sees it

  explicit StageHost(const HostedStages& stages, const rpc::CallGateOptions& gate = {4, 0},
                     const rpc::ServerOptions& options = {});

  std::string Address() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  rpc::Server& server() { return *server_; }

 private:
  rpc::Metrics metrics_;
  rpc::CallMetrics call_metrics_{metrics_.registry()};
  rpc::CallGate gate_;
  const std::unique_ptr<ArrangingStage> arranging_ = slicing::MakeLocalArranging();
  slicing::SlicingService slicing_;
  const std::unique_ptr<v1::Planning::Service> planning_;
  beading::BeadingService beading_;
  infill::InfillService infill_;
  ordering::OrderingService ordering_;
  motion::MotionService motion_;
  std::optional<exposure::ExposureService> exposure_;
  worker::WorkerService worker_;
  std::unique_ptr<rpc::Server> server_;
};

/// A log that nobody reads.
rpc::JsonLog NoLog();

}  // namespace slicefarm
