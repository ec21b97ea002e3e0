#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::planning {

/// The plans of a job's layers, but for those that are settled and were taken.
class OpenLayers {
 public:
  /// The plan of the next layer, which is empty.
  LayerPlan& Add() { return plans_.emplace_back(); }

  /// REQUIRES: the layer was added, and is not taken.
  LayerPlan& At(int32_t layer) { return plans_[static_cast<size_t>(layer - first_)]; }

  int32_t first() const { return first_; }

  /// One above the last.
  int32_t end() const { return first_ + static_cast<int32_t>(plans_.size()); }

  /// The plans below that of `layer`, from the lowest up.
  std::vector<LayerPlan> TakeBelow(int32_t layer);

 private:
  std::deque<LayerPlan> plans_;
  int32_t first_ = 0;
};

/// Decides one thing over a whole job. Planners run one after the other on each layer, bottom up,
/// and each adds to the plan; see JobPlanner for their order.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Looks at the next layer. `plan` is that layer's.
  virtual void Look(const SlicedLayer& layer, LayerPlan& plan) = 0;

  /// After each Look: may add to plans of the layers so far. Below the layer that it answers, the
  /// planner will not add to any.
  virtual int32_t Settle(OpenLayers& layers) { return layers.end(); }

  /// After the last layer: adds what depends on more layers than one, to `layers` and to `plan`,
  /// which has none. May take long, and is Cancelled when `cancel` asks for it.
  virtual absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
    (void)cancel, (void)layers, (void)plan;
    return absl::OkStatus();
  }

  /// What it keeps of the layers that it has seen, beyond those that are open.
  virtual int64_t HeldBytes() const { return 0; }
};

/// The plan of a stack's section in a layer, by its id; made if there is none.
SectionPlan& PlanOf(int32_t stack, LayerPlan& plan);

/// What messages call an object. `names`: by object; may be fewer.
std::string NameOf(int32_t object, std::span<const std::string> names);

/// What messages call a copy: its object, and which copy it is if there are several.
std::string NameOfCopy(size_t copy, std::span<const PlacedCopy> copies,
                       std::span<const std::string> names);

}  // namespace slicefarm::planning
