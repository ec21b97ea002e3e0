#include <sys/resource.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "common/model/limits.h"
#include "common/rpc/client/channel.h"
#include "common/rpc/client/duplex_call.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "services/planning/algo/job_planner.h"
#include "slicefarm/v1/planning.grpc.pb.h"
#include "tests/bench/benchmarks.h"
#include "tests/integration/child_process.h"

namespace slicefarm::bench {
namespace {

double CpuSeconds() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Returns the peak memory of a process, in MB.
double PeakMb(const std::string& process) {
  std::ifstream status("/proc/" + process + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

/// Returns octagons in rows that grow and shrink a little from layer to layer, so that seams have
/// to follow them.
SlicedLayer LayerOf(int32_t index, int islands) {
  ObjectSection section;
  section.layer = index;
  section.layer_count = index + 1;
  section.height_nm = 200'000;
  Region& region = section.regions.emplace_back();
  const Coord r = 800'000 + 1'000 * (index % 100), c = r * 2 / 5;
  for (int i = 0; i < islands; ++i) {
    const Point at{FromMm(3) * (i % 32), FromMm(3) * (i / 32)};
    PolygonWithHoles& island = region.outlines.emplace_back();
    for (const Point p :
         {Point{r, -c}, {r, c}, {c, r}, {-c, r}, {-r, c}, {-r, -c}, {-c, -r}, {c, -r}})
      island.outer.push_back(at + p);
  }
  return {{index, (index + 1) * Coord{10'000}, 10'000}, {std::move(section)}};
}

/// Plans in this program and keeps all plans.
bool PlanHere(int32_t layers, int islands) {
  const PlanningOptions options;
  const std::vector<PlacedCopy> copies = {{0, {FromMm(100), FromMm(100)}, {}}};
  auto planner = planning::JobPlanner::Make(options, copies);
  if (!planner.ok()) return false;
  double cpu_s = 0;
  for (int32_t i = 0; i < layers; ++i) {
    const SlicedLayer layer = LayerOf(i, islands);
    const double before = CpuSeconds();
    if (!planner->Next(layer).ok()) return false;
    cpu_s += CpuSeconds() - before;
  }
  const double before = CpuSeconds();
  const auto plan = planner->Finish();
  cpu_s += CpuSeconds() - before;
  if (!plan.ok() || std::ssize(plan->layers) != layers) return false;
  std::printf("here_layers %d\nhere_islands %d\nhere_cpu_s %.2f\nhere_peak_mb %.0f\n", layers,
              islands, cpu_s, PeakMb("self"));
  return true;
}

/// Plans with slicefarm-planning. The answers are counted and discarded.
bool PlanThere(int32_t layers, int islands) {
  const ServerProcess server("slicefarm-planning");
  const std::string pid = std::to_string(server.process.pid());
  const std::shared_ptr<grpc::Channel> channel = rpc::MakeChannel(server.address, {});
  int64_t plans = 0, plans_before_the_end = 0;
  rpc::DuplexCall<v1::PlanRequest, v1::PlanResponse> call(
      {std::chrono::minutes(30)},
      [&](auto* context, auto* queue) {
        return v1::Planning::Stub(channel).PrepareAsyncPlanJob(context, queue);
      },
      [&](const v1::PlanResponse& response) {
        plans += response.has_layer();
        return absl::OkStatus();
      });
  v1::PlanRequest request;
  const PlanStart start{{}, {}, {{0, {FromMm(100), FromMm(100)}, {}}}, {}};
  if (!ToProto(start, request.mutable_start()).ok() || !call.Write(request)) return false;
  for (int32_t i = 0; i < layers; ++i) {
    if (!ToProto(LayerOf(i, islands), request.mutable_layer()).ok() || !call.Write(request))
      return false;
    request.Clear();
  }
  plans_before_the_end = plans;
  if (const absl::Status end = call.Finish(); !end.ok()) {
    std::fprintf(stderr, "%s\n", end.ToString().c_str());
    return false;
  }
  std::printf(
      "there_layers %d\nthere_islands %d\nthere_plans_before_the_end %.3f\n"
      "there_peak_mb %.0f\n",
      layers, islands, static_cast<double>(plans_before_the_end) / layers, PeakMb(pid));
  return plans == layers;
}

}  // namespace

int BenchPlanning() {
  constexpr int32_t kLayers = 100'000;
  constexpr int kIslands = 100;
  // A job cannot have more layers than this, so fewer layers get more islands.
  constexpr auto kMost = static_cast<int32_t>(limits::kMaxLayers);
  const bool ok = PlanThere(kMost, kLayers / kMost * kIslands) && PlanHere(kLayers, kIslands);
  return ok ? 0 : 1;
}

}  // namespace slicefarm::bench
