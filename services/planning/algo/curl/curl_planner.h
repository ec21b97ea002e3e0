#pragma once

#include <cstdint>
#include <map>

#include "services/planning/algo/curl/curled_edges.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans areas where the part curls up above its layer (CurledEdges), so that travels avoid these
/// areas (avoid_crossing_curled_overhangs).
class CurlPlanner : public Planner {
 public:
  /// `options` must outlive this planner.
  explicit CurlPlanner(const PlanningOptions& options) : options_(options) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;

 private:
  const PlanningOptions& options_;
  std::map<int32_t, CurledEdges> objects_;
};

}  // namespace slicefarm::planning
