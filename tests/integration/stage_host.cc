#include "tests/integration/stage_host.h"

#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "services/beading/server/beading_service.h"
#include "services/exposure/server/exposure_service.h"
#include "services/infill/server/infill_service.h"
#include "services/milling/server/milling_service.h"
#include "services/motion/server/motion_service.h"
#include "services/ordering/server/ordering_service.h"
#include "services/slicing/server/slicing_service.h"
#include "services/texture/server/texture_service.h"
#include "services/worker/server/worker_service.h"

namespace slicefarm {

rpc::JsonLog NoLog() {
  return rpc::JsonLog("test", std::make_shared<spdlog::logger>(
                                  "test", std::make_shared<spdlog::sinks::null_sink_mt>()));
}

StageHost::StageHost(const HostedStages& stages, const rpc::CallLimiterOptions& gate,
                     const rpc::ServerOptions& options)
    : gate_(gate, NoLog()), keeper_(NoLog()) {
  services_.push_back(slicing::MakeSlicingService(
      stages.slicing, *arranging_, *placing_,
      slicing::MakeReadProjects(slicing::MakeDirectMeshSource()), gate_, kThreads, memory_));
  services_.push_back(stages.planning(gate_));
  services_.push_back(beading::MakeBeadingService(stages.beading, gate_, keeper_.cache()));
  services_.push_back(infill::MakeInfillService(stages.infill, gate_, keeper_.cache()));
  services_.push_back(ordering::MakeOrderingService(stages.ordering, gate_, keeper_.cache()));
  services_.push_back(motion::MakeMotionService(stages.motion, gate_, keeper_.cache()));
  services_.push_back(worker::MakeWorkerService(stages.runner, gate_, keeper_.cache()));
  if (stages.exposure != nullptr)
    services_.push_back(exposure::MakeExposureService(*stages.exposure, gate_, keeper_.cache()));
  if (stages.milling != nullptr)
    services_.push_back(milling::MakeMillingService(*stages.milling, gate_, keeper_.cache()));
  if (stages.texture != nullptr)
    services_.push_back(texture::MakeTextureService(*stages.texture, gate_, keeper_.cache()));
  std::vector<grpc::Service*> services = {&keeper_.service()};
  for (const auto& service : services_) services.push_back(service.get());
  auto server = rpc::Server::Start(options, services, call_metrics_);
  if (!server.ok()) {
    std::fprintf(stderr, "%s\n", server.status().ToString().c_str());
    std::abort();
  }
  server_ = *std::move(server);
}

}  // namespace slicefarm
