#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "common/stage/stages.h"

namespace slicefarm {

/// What the fakes were asked, and what they are to do before they answer with the sample results.
struct FakeStages {
  std::function<absl::Status(const StageCall&)> before = [](const StageCall&) {
    return absl::OkStatus();
  };
  /// One layer is missing from every answer.
  bool lose_a_layer = false;

  // Of the last call:
  StageCall call;
  SliceInput slice_input;
  SlicingOptions slicing_options;
  LayerRange range;
  int32_t layer_count = 0;
  std::vector<SlicedLayer> layers;
  BeadingOptions beading_options;
  std::vector<WalledLayer> walled;
  InfillOptions infill_options;
  std::vector<FilledLayer> filled;
  std::vector<LayerPlan> plans;
  OrderingOptions ordering_options;
  std::vector<OrderedLayer> ordered;
  MotionOptions motion_options;
  ProgramSummary summary;
  JobSettings settings;
};

/// A small job in every state of its way: two layers to work on, [3, 5), of ten, with a halo of
/// one.
struct Sample {
  static constexpr LayerRange kRange{3, 5};
  static constexpr int32_t kLayerCount = 10;

  SliceInput input;
  SlicedJob job;                      ///< layers 0, 1, 2
  std::vector<SlicedLayer> outlines;  ///< layers 2 to 5
  std::vector<WalledLayer> walled;
  std::vector<FilledLayer> filled;
  std::vector<LayerPlan> plans;
  std::vector<OrderedLayer> ordered;
  std::vector<LayerProgram> programs;
  ProgramSummary summary;
  ProgramFrame frame;
  JobSettings settings;  ///< of no default
  StageTimes times;
};
const Sample& TheSample();

/// The stages as fakes: each notes what it was asked in `fakes`, and answers what TheSample() has.
class FakeSlicing : public SlicingStage {
 public:
  explicit FakeSlicing(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeBeading : public BeadingStage {
 public:
  explicit FakeBeading(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const BeadingOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeInfill : public InfillStage {
 public:
  explicit FakeInfill(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                const InfillOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeOrdering : public OrderingStage {
 public:
  explicit FakeOrdering(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<OrderedLayer>> Order(const StageCall& call,
                                                  std::vector<FilledLayer> layers,
                                                  std::span<const LayerPlan> plans,
                                                  const OrderingOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeMotion : public MotionStage {
 public:
  explicit FakeMotion(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const MotionOptions& options) const override;
  absl::StatusOr<ProgramFrame> Frame(const StageCall& call, const ProgramSummary& summary,
                                     const MotionOptions& options) const override;

 private:
  FakeStages& fakes_;
};

class FakeRunner : public RangeRunner {
 public:
  explicit FakeRunner(FakeStages& fakes) : fakes_(fakes) {}
  absl::StatusOr<RangeResult> Run(const StageCall& call, const RangeTask& task) const override;

 private:
  FakeStages& fakes_;
};

}  // namespace slicefarm
