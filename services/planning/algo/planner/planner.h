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

/// Plans of a job's layers that have not been taken yet. A plan is taken when no planner will
/// change it any more.
class OpenLayers {
 public:
  /// Adds an empty plan for the next layer and returns it.
  LayerPlan& Add() { return plans_.emplace_back(); }

  /// Returns the plan of a layer. REQUIRES: the layer was added and not yet taken.
  LayerPlan& At(int32_t layer) { return plans_[static_cast<size_t>(layer - first_)]; }

  int32_t first() const { return first_; }

  /// Returns the index of the layer that Add adds next.
  int32_t end() const { return first_ + static_cast<int32_t>(plans_.size()); }

  /// Removes and returns the plans of the layers below `layer`, from the lowest up.
  std::vector<LayerPlan> TakeBelow(int32_t layer);

 private:
  std::deque<LayerPlan> plans_;
  int32_t first_ = 0;
};

/// Plans one aspect of a whole job. JobPlanner calls its planners one after the other for each
/// layer, bottom up, in a fixed order. Each planner adds to the layer's plan.
class Planner {
 public:
  virtual ~Planner() = default;

  /// Processes the next layer of the print. `plan` is the plan of this layer.
  virtual void Look(const SlicedLayer& layer, LayerPlan& plan) = 0;

  /// Called after each Look. May add to the plans of all layers so far. Returns the index of the
  /// lowest layer that this planner may still change.
  virtual int32_t Revise(OpenLayers& layers) { return layers.end(); }

  /// Called after the last layer. Adds results that depend on several layers: to `layers`, or to
  /// `plan`, which has no layers yet. May take long. Returns Cancelled if `cancel` requests it.
  virtual absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
    (void)cancel, (void)layers, (void)plan;
    return absl::OkStatus();
  }

  /// Returns the memory in bytes that the planner uses for past layers, without the open plans.
  virtual int64_t HeldBytes() const { return 0; }
};

/// Returns the plan of one stack's section in the layer plan `plan`. Adds the section's plan if it
/// is missing. `stack`: id of the stack.
SectionPlan& PlanOf(int32_t stack, LayerPlan& plan);

/// Returns the name of an object for messages. `names`: names, indexed by object. If it has no
/// entry for the object, the result contains the object's number.
std::string NameOf(int32_t object, std::span<const std::string> names);

/// Returns the name of a copy for messages: its object, and the number of the copy if there are
/// several.
std::string NameOfCopy(size_t copy, std::span<const PlacedCopy> copies,
                       std::span<const std::string> names);

}  // namespace slicefarm::planning
