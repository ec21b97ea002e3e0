#pragma once

#include <map>
#include <vector>

#include "common/model/planning_options.h"
#include "services/planning/algo/planner.h"
#include "services/planning/algo/seams/seam_chain.h"

namespace slicefarm::planning {

/// Where the walls of each ring start, by the object's seam position:
///   `rear`: the rear-most vertex of the ring; `aligned`: a chain up the object (seam_chain.h);
///   `nearest`: nothing, so each layer decides.
/// Cost: O(points * rings of the object's layer below that overlap) a layer. Memory: one layer.
class SeamPlanner : public Planner {
 public:
  /// `options` must outlive this.
  explicit SeamPlanner(const PlanningOptions& options) : options_(options) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;

 private:
  const PlanningOptions& options_;
  std::map<int32_t, SeamChain> chains_;  ///< by object
};

}  // namespace slicefarm::planning
