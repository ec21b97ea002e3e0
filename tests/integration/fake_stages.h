#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/server_stream.h"
#include "common/stage/beading_stage.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/neighbourhood.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/slice_input.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/task.h"
#include "processes/fdm/model/fdm_settings.h"
#include "processes/fdm/task/fdm_task.h"
#include "processes/laser/model/exposed_program.h"
#include "processes/laser/model/exposure_settings.h"
#include "slicefarm/v1/planning.grpc.pb.h"

namespace slicefarm {

/// State of the fake stages: the arguments of the last call, and the function `before`, which each
/// stage calls before it answers with the sample results. If `before` returns an error, the answer
/// is this error.
struct FakeStages {
  std::function<absl::Status(const StageCall&)> before = [](const StageCall&) {
    return absl::OkStatus();
  };
  /// If true, each answer lacks one layer.
  bool lose_a_layer = false;

  // Arguments of the last call:
  StageCall call;
  SliceInput slice_input;
  SlicingOptions slicing_options;
  std::vector<PlacedCopy> placed;
  PlanningOptions planning_options;
  LayerRange range;
  std::vector<SlicedLayer> layers;
  std::vector<BeadingOptions> beading_options;
  std::vector<WalledLayer> walled;
  std::vector<InfillOptions> infill_options;
  std::vector<LayerPlan> infill_plans;
  std::vector<FilledLayer> filled;
  std::vector<LayerPlan> plans;
  std::vector<Copy> copies;
  OrderingOptions ordering_options;
  std::vector<OrderedLayer> ordered;
  JobFacts facts;
  MotionOptions motion_options;
  ProgramSummary summary;
  ExposureSettings exposure;
  ExposureSummary exposure_summary;
  FdmSettings fdm_settings;
};

/// A small job in all intermediate states. It has ten layers; the range to work on is [3, 5), with
/// a halo of one layer. Objects 0 and 2 are printed. Object 0 has two regions and is printed in two
/// passes (Copy::pass).
struct Sample {
  static constexpr LayerRange kRange{3, 5};
  static constexpr int32_t kLayerCount = 10;

  SliceInput input;
  SlicedJob job;                      ///< layers 0, 1, 2
  JobPlan plan;                       ///< plan of these layers
  std::vector<SlicedLayer> outlines;  ///< layers 2 to 5
  std::vector<WalledLayer> walled;
  std::vector<FilledLayer> filled;
  std::vector<LayerPlan> plans;
  std::vector<OrderedLayer> ordered;
  JobFacts facts;
  std::vector<LayerProgram> programs;
  std::vector<LayerWarning> warnings;
  std::vector<FillStats> fills;
  std::vector<ExposedProgram> exposed;
  ProgramSummary summary;
  ProgramEnvelope frame;
  JobSettings settings;  ///< settings that differ from the default values
  /// exposure settings that differ from the default values
  ExposureSettings exposure_settings;
  StageTimes times;
};
const Sample& TheSample();

/// Fake stages: each records its arguments in `fakes` and answers with the results of TheSample().
class FakeSlicing : public SlicingStage {
 public:
  explicit FakeSlicing(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override;

 private:
  FakeStages& fakes_;
};

/// Fake of the planning service. It replaces the whole service, because the planning algorithm has
/// no stage class of its own.
class FakePlanning final : public v1::Planning::Service {
 public:
  FakePlanning(FakeStages& fakes, rpc::CallLimiter& gate) : fakes_(fakes), gate_(gate) {}
  grpc::Status PlanJob(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::PlanResponse, v1::PlanRequest>* stream) override;

 private:
  using Stream = rpc::ServerStream<v1::PlanResponse, v1::PlanRequest>;
  absl::Status Plan(rpc::Call& call, Stream& stream);

  FakeStages& fakes_;
  rpc::CallLimiter& gate_;
};

class FakeBeading : public BeadingStage {
 public:
  explicit FakeBeading(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const Shared<BeadingTable>& regions) const override;

 private:
  FakeStages& fakes_;
};

class FakeInfill : public InfillStage {
 public:
  explicit FakeInfill(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                std::span<const LayerPlan> plans,
                                                const Shared<InfillTable>& regions) const override;

 private:
  FakeStages& fakes_;
};

class FakeOrdering : public OrderingStage {
 public:
  explicit FakeOrdering(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                  std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const Shared<OrderingJob>& job) const override;

 private:
  FakeStages& fakes_;
};

class FakeMotion : public MotionStage {
 public:
  explicit FakeMotion(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>& job) const override;
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call, const ProgramSummary& summary,
                                           const MotionOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeExposure : public ExposureStage {
 public:
  explicit FakeExposure(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<ExposedProgram>> Expose(const StageCall& call,
                                                     const Neighbourhood& neighbourhood,
                                                     const Shared<ExposureJob>& job) const override;
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& call, const ExposureSummary& summary,
                                            const ExposureSettings& settings) const override;

 private:
  FakeStages& fakes_;
};

/// Runs a task of filament printing and returns its result.
absl::StatusOr<FdmResult> RunFdm(const TaskRunner& runner, const StageCall& call,
                                 const FdmTask& task);

class FakeRunner : public FdmRunner {
 public:
  explicit FakeRunner(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override;

 private:
  FakeStages& fakes_;
};

}  // namespace slicefarm
