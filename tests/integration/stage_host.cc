#include "tests/integration/stage_host.h"

#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace slicefarm {

rpc::JsonLog NoLog() {
  return rpc::JsonLog("test", std::make_shared<spdlog::logger>(
                                  "test", std::make_shared<spdlog::sinks::null_sink_mt>()));
}

StageHost::StageHost(const HostedStages& stages, const rpc::CallGateOptions& gate,
                     const rpc::ServerOptions& options)
    : gate_(gate, NoLog()),
      slicing_(stages.slicing, *arranging_, gate_, kThreads),
      planning_(stages.planning(gate_)),
      beading_(stages.beading, gate_),
      infill_(stages.infill, gate_),
      ordering_(stages.ordering, gate_),
      motion_(stages.motion, gate_),
      worker_(stages.runner, gate_) {
  std::vector<grpc::Service*> services = {&slicing_,  planning_.get(), &beading_, &infill_,
                                          &ordering_, &motion_,        &worker_};
  if (stages.exposure != nullptr) {
    exposure_.emplace(*stages.exposure, gate_);
    services.push_back(&*exposure_);
  }
  auto server = rpc::Server::Start(options, services, call_metrics_);
  if (!server.ok()) {
    std::fprintf(stderr, "%s\n", server.status().ToString().c_str());
    std::abort();
  }
  server_ = *std::move(server);
}

}  // namespace slicefarm
