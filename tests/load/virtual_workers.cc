// Workers that sleep instead of working. They test the coordinator with more workers than this
// machine has cores.
//
// Prints the addresses of the workers in one line, and serves until a signal ends it.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_join.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/observe/metrics.h"
#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/open_files.h"
#include "common/rpc/server/server.h"
#include "common/rpc/server/shared_store.h"
#include "common/rpc/server/shutdown_signal.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/worker/server/worker_service.h"

namespace slicefarm {
namespace {

/// Runner that sleeps for a fixed time per layer, and makes one line of G-code per layer.
class SleepingRunner final : public FdmRunner {
 public:
  explicit SleepingRunner(std::chrono::duration<double, std::milli> layer) : layer_(layer) {}

  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override {
    FdmResult result;
    for (const SlicedLayer& layer : task.layers) {
      if (!task.range.Contains(layer.frame.index)) continue;
      if (absl::Status go_on = call.cancel.Check(); !go_on.ok()) return go_on;
      std::this_thread::sleep_for(layer_);
      LayerProgram program;
      program.frame = layer.frame;
      program.gcode = "; slept\n";
      program.stats.features[0] = {.time_s = 1, .length_mm = 1, .filament_mm = 1, .volume_mm3 = 1};
      result.programs.push_back(std::move(program));
    }
    return result;
  }

 private:
  const std::chrono::duration<double, std::milli> layer_;
};

struct VirtualWorker {
  VirtualWorker(const FdmRunner& runner, const rpc::JsonLog& log, rpc::CallMetrics& metrics)
      : gate({.slots = 1, .queue = 4}, log),
        keeper(log),
        service(worker::MakeWorkerService(runner, gate, keeper.cache())),
        server(*rpc::Server::Start({}, {service.get(), &keeper.service()}, metrics)) {}

  rpc::CallLimiter gate;
  rpc::SharedStore keeper;
  std::unique_ptr<grpc::Service> service;
  std::unique_ptr<rpc::Server> server;
};

}  // namespace
}  // namespace slicefarm

int main(int argc, char** argv) {
  using namespace slicefarm;
  CLI::App app("Run virtual workers that sleep instead of slicing");
  int count = 64;
  double layer_ms = 50;
  app.add_option("--count", count, "Number of workers, with one slot each")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--layer-ms", layer_ms, "Milliseconds that a layer takes")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  rpc::RaiseOpenFilesLimit();
  rpc::ShutdownSignal signal;
  const rpc::JsonLog log("virtual-workers");
  rpc::Metrics metrics;
  rpc::CallMetrics call_metrics(metrics.registry());
  const SleepingRunner runner{std::chrono::duration<double, std::milli>(layer_ms)};
  std::vector<std::unique_ptr<VirtualWorker>> workers;
  for (int i = 0; i < count; ++i)
    workers.push_back(std::make_unique<VirtualWorker>(runner, log, call_metrics));
  std::printf("%s\n", absl::StrJoin(workers, ",", [](std::string* out, const auto& worker) {
                        out->append("127.0.0.1:" + std::to_string(worker->server->port()));
                      }).c_str());
  std::fflush(stdout);
  signal.Wait();
}
