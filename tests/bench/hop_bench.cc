#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/rpc/security/identity.h"
#include "common/rpc/security/tls.h"
#include "common/stage/motion_job.h"
#include "common/stage/object_layers.h"
#include "common/stage/ordering_job.h"
#include "common/stage/slice_input_test.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/layers/program_wire.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/coordinator/algo/pipeline/range_split.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/bench/benchmarks.h"
#include "tests/corpus_file.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"

namespace slicefarm::bench {
namespace {

constexpr int kRuns = 7;
constexpr int kSlots = 4;  // as on a farm of four workers; sets the range length

struct Cost {
  double wall_s = 0;
  double cpu_s = 0;  ///< CPU time of this program: client, server and gRPC's threads
};

double CpuSeconds() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return t.tv_sec + t.tv_usec / 1e6; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Returns the least cost of a few runs.
Cost Measure(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  Cost best{1e9, 1e9};
  for (int run = 0; run < kRuns; ++run) {
    const double cpu = CpuSeconds();
    const auto wall = Clock::now();
    work();
    best.wall_s = std::min(best.wall_s, std::chrono::duration<double>(Clock::now() - wall).count());
    best.cpu_s = std::min(best.cpu_s, CpuSeconds() - cpu);
  }
  return best;
}

template <typename Layer>
std::vector<Layer> Part(const std::vector<Layer>& layers, LayerRange range) {
  return {layers.begin() + range.first, layers.begin() + range.last};
}

/// A job in every intermediate state.
struct Job {
  SliceInput input;
  JobSettings settings;
  SlicedJob sliced;
  JobPlan plan;
  JobFacts facts;
  Shared<FdmShared> shared;  ///< settings, copies and facts
  std::vector<WalledLayer> walled;
  std::vector<FilledLayer> filled;
  std::vector<OrderedLayer> ordered;
  std::vector<LayerProgram> programs;
  std::vector<LayerRange> ranges;

  int32_t layer_count() const { return static_cast<int32_t>(sliced.layers.size()); }
  LayerRange Halo(LayerRange range) const {
    return WithHalo(sliced.layers, range, HaloLayers(FdmOf(settings)));
  }
  Neighbourhood Around(LayerRange range) const {
    const LayerRange halo = Halo(range);
    return {range, std::span(sliced.layers).subspan(halo.first, halo.size())};
  }
  FdmTask Task(LayerRange range) const {
    return {.range = range,
            .layers = Around(range).layers,
            .plans = std::span(plan.layers).subspan(range.first, range.size()),
            .job = shared};
  }
  SlicedOutlines outlines() const { return {sliced.layers, sliced.copies}; }
};

/// Slicing stage that returns the answer of `job` without any work, so that the whole cost of a
/// call is the cost of the hop. CannedStages does this for the remaining stages.
class CannedSlicing : public SlicingStage {
 public:
  explicit CannedSlicing(const Job& job) : job_(job) {}
  absl::StatusOr<SlicedJob> Slice(const StageCall&, SliceInput,
                                  const SlicingOptions&) const override {
    return job_.sliced;
  }

 private:
  const Job& job_;
};

class CannedStages : public BeadingStage,
                     public InfillStage,
                     public OrderingStage,
                     public MotionStage,
                     public FdmRunner {
 public:
  explicit CannedStages(const Job& job) : job_(job) {}
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall&, const Neighbourhood& n,
                                                const Shared<BeadingTable>&) const override {
    return Part(job_.walled, n.range);
  }
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall&, std::vector<WalledLayer>,
                                                const Neighbourhood& n, std::span<const LayerPlan>,
                                                const Shared<InfillTable>&) const override {
    return Part(job_.filled, n.range);
  }
  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall&, std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan>,
                                                  const Shared<OrderingJob>&) const override {
    return Part(job_.ordered, RangeOf(layers));
  }
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>&) const override {
    return Part(job_.programs, RangeOf(layers));
  }
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall&, const ProgramSummary&,
                                           const MotionOptions&) const override {
    return ProgramEnvelope{};
  }
  absl::StatusOr<FdmResult> Run(const StageCall&, const FdmTask& task) const override {
    return FdmResult{Part(job_.programs, task.range), {}, {}, {}};
  }

 private:
  const Job& job_;
};

SliceInput Benchy() {
  return InputOf({{"benchy.stl", MeshFormat::kStl, CorpusFile("models/benchy.stl")}});
}

/// Cost of a job with the stages of this program.
struct LocalCost {
  Cost job;
  Cost planning;  ///< part of `job` that planning costs
};

absl::StatusOr<LocalCost> Compute(Job* job) {
  const auto slicing = slicing::MakeLocalSlicing();
  const auto planning = planning::MakeLocalPlanning();
  const auto beading = beading::MakeLocalBeading();
  const auto infill = infill::MakeLocalInfill();
  const auto ordering = ordering::MakeLocalOrdering();
  const auto motion = motion::MakeLocalMotion();
  absl::Status status;
  const auto keep = [&status](auto result, auto* value) {
    status.Update(result.status());
    if (result.ok()) *value = *std::move(result);
  };
  const Cost cost = Measure([&] {
    keep(slicing->Slice({}, job->input, job->settings.slicing), &job->sliced);
    keep(planning->Plan({}, job->outlines(), PlanningOf(FdmOf(job->settings))), &job->plan);
    const Neighbourhood all = job->Around({0, job->layer_count()});
    keep(beading->Bead({}, all, BeadingOf(FdmOf(job->settings))), &job->walled);
    keep(infill->Fill({}, job->walled, all, job->plan.layers, InfillOf(FdmOf(job->settings))),
         &job->filled);
    keep(ordering->Order({}, job->filled, job->plan.layers,
                         OrderingJob{OrderingOf(FdmOf(job->settings)), job->plan.copies}),
         &job->ordered);
    job->facts = {job->layer_count(), {}, {}};
    keep(motion->Program({}, job->ordered, MotionJob{MotionOf(FdmOf(job->settings)), job->facts}),
         &job->programs);
  });
  const Cost plan = Measure([&] {
    keep(planning->Plan({}, job->outlines(), PlanningOf(FdmOf(job->settings))), &job->plan);
  });
  if (!status.ok()) return status;
  job->shared = FdmShared{FdmOf(job->settings), job->plan.copies, job->facts};
  job->ranges = coordinator::SplitIntoRanges(job->sliced.layers, kSlots);
  return LocalCost{cost, plan};
}

template <typename Proto, typename Layer>
double Bytes(const std::vector<Layer>& layers) {
  double bytes = 0;
  for (const Layer& layer : layers) {
    Proto proto;
    (void)ToProto(layer, &proto);
    bytes += static_cast<double>(proto.ByteSizeLong());
  }
  return bytes;
}

/// Bytes of the layer messages in both directions, for all calls of a job together.
struct Traffic {
  double planned = 0;  ///< outlines to planning, and plans back
  double sliced = 0;   ///< outlines with the ranges' halos, once
  double walled = 0;
  double filled = 0;
  double ordered = 0;
  double programs = 0;

  double fused() const { return sliced + programs; }
  double split() const { return 2 * (sliced + walled + filled + ordered) + programs; }
};

Traffic Count(const Job& job) {
  Traffic traffic;
  traffic.planned =
      Bytes<v1::SlicedLayer>(job.sliced.layers) + Bytes<v1::LayerPlan>(job.plan.layers);
  for (const LayerRange range : job.ranges) {
    traffic.sliced += Bytes<v1::SlicedLayer>(Part(job.sliced.layers, job.Halo(range)));
  }
  traffic.walled = Bytes<v1::WalledLayer>(job.walled);
  traffic.filled = Bytes<v1::FilledLayer>(job.filled);
  traffic.ordered = Bytes<v1::OrderedLayer>(job.ordered);
  traffic.programs = Bytes<v1::LayerProgram>(job.programs);
  return traffic;
}

/// Clients of canned stages over a real socket.
class Farm {
 public:
  /// `tls`: null for plain text.
  Farm(const Job& job, const rpc::Tls* tls)
      : job_(job),
        canned_slicing_(job),
        canned_(job),
        host_({canned_slicing_, canned_, canned_, canned_, canned_, canned_}, {4, 0},
              {.credentials = tls ? tls->ForServer(rpc::ClientCerts::kRequired) : nullptr}),
        remote_(
            host_.Address(), {},
            {.credentials = tls ? tls->ForIdentity(rpc::kCoordinatorIdentity, NoLog()) : nullptr}) {
  }

  /// Each function returns false if a call failed.
  bool Slice() const { return remote_.slicing.Slice({}, job_.input, job_.settings.slicing).ok(); }
  /// Plans with the real planning service, which contains its algorithm.
  bool Plan() const {
    return remote_.planning.Plan({}, job_.outlines(), PlanningOf(FdmOf(job_.settings))).ok();
  }
  bool Fused() const {
    return std::ranges::all_of(job_.ranges, [this](LayerRange range) {
      return remote_.worker.RunTask({}, job_.Task(range)).ok();
    });
  }
  bool Split() const {
    const LayerChain chain(remote_.beading, remote_.infill, remote_.ordering, remote_.motion);
    return std::ranges::all_of(
        job_.ranges, [&](LayerRange range) { return chain.Run({}, job_.Task(range)).ok(); });
  }

 private:
  const Job& job_;
  const CannedSlicing canned_slicing_;
  const CannedStages canned_;
  StageHost host_;
  const RemoteClients remote_;
};

/// Prints one row. `once_cpu_s`: CPU time of the hops that a job makes once, to slicing and to
/// planning.
void Print(const char* path, double bytes, const Cost& hops, double once_cpu_s, double job_cpu_s,
           int32_t layers) {
  const double transport_s = hops.cpu_s + once_cpu_s;
  std::printf("%s_kbytes_per_layer %.2f\n", path, bytes / 1000 / layers);
  std::printf("%s_wall_ms_per_layer %.4f\n", path, hops.wall_s * 1000 / layers);
  std::printf("%s_cpu_ms_per_layer %.4f\n", path, hops.cpu_s * 1000 / layers);
  std::printf("%s_transport_share %.4f\n", path, transport_s / (transport_s + job_cpu_s));
}

/// Measures the cost of hops between processes on the benchy: bytes, time and CPU time per layer,
/// for fused workers (one hop) and for split stages (four hops). Also prints their share of a job's
/// CPU time, with the hops of the mesh to slicing and of the outlines to planning.
int Bench(const rpc::Tls* tls) {
  Job job;
  job.input = Benchy();
  const absl::StatusOr<LocalCost> local = Compute(&job);
  if (!local.ok()) {
    std::fprintf(stderr, "%s\n", local.status().ToString().c_str());
    return 1;
  }
  const Farm farm(job, tls);
  bool sound = true;
  const Cost slicing = Measure([&] { sound &= farm.Slice(); });
  const Cost planning = Measure([&] { sound &= farm.Plan(); });
  const double planning_hop_s = std::max(0.0, planning.cpu_s - local->planning.cpu_s);
  const double once_s = slicing.cpu_s + planning_hop_s;
  const Cost fused = Measure([&] { sound &= farm.Fused(); });
  const Cost split = Measure([&] { sound &= farm.Split(); });
  const Traffic traffic = Count(job);
  std::printf("layers %d\nranges %zu\n", job.layer_count(), job.ranges.size());
  std::printf("job_cpu_s %.4f\n", local->job.cpu_s);
  std::printf("slicing_hop_cpu_s %.4f\n", slicing.cpu_s);
  std::printf("planning_hop_cpu_s %.4f\n", planning_hop_s);
  std::printf("planning_kbytes_per_layer %.2f\n", traffic.planned / 1000 / job.layer_count());
  Print("fused", traffic.fused(), fused, once_s, local->job.cpu_s, job.layer_count());
  Print("split", traffic.split(), split, once_s, local->job.cpu_s, job.layer_count());
  return sound ? 0 : 1;
}

}  // namespace

int BenchHop() { return Bench(nullptr); }

int BenchHopWithTls(const std::string& certs) {
  const std::string files = certs + "/coordinator";
  const auto tls = rpc::Tls::Open({files + "/cert.pem", files + "/key.pem", files + "/ca.pem"});
  if (tls.ok()) return Bench(tls->get());
  std::fprintf(stderr, "%s\n", tls.status().ToString().c_str());
  return 1;
}

}  // namespace slicefarm::bench
