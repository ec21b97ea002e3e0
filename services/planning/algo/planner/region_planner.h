#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm::planning {

/// Result of the region planners so far.
struct RegionPlan {
  int32_t next_id = 0;  ///< id of the next stack
  /// height of each object's bottom above the bed, indexed by object; 0 beyond the end
  std::vector<Coord> lifts_nm;
  std::vector<AddedStack> stacks;     ///< added stacks, sorted by id
  std::vector<std::string> warnings;  ///< texts for the job's report
  /// Areas directly above supports; the key is the object and the layer of the object's part.
  using AreasAboveSupports = std::map<std::pair<int32_t, int32_t>, MultiPolygon>;
  AreasAboveSupports above_supports;

  /// Adds a stack without layers.
  AddedStack& Add(int32_t object, StackKind kind) {
    stacks.push_back({Stack(next_id++, object, kind), 0, {}});
    return stacks.back();
  }
};

/// Adds stacks that have layers of their own, before the layers of the print are known. JobPlanner
/// runs its region planners in a fixed order. Each one gets the stacks that earlier planners added.
class RegionPlanner {
 public:
  virtual ~RegionPlanner() = default;

  /// Adds stacks to `plan`. `parts`: all layers of all parts, with heights above the part's own
  /// bottom. Returns Cancelled if `cancel` requests it.
  virtual absl::Status Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                            RegionPlan& plan) = 0;
};

}  // namespace slicefarm::planning
