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

/// The stacks that planning adds, as far as they are known.
struct RegionPlan {
  int32_t next_id = 0;              ///< of the stack that comes next
  std::vector<Coord> lifts_nm;      ///< by object: its part's bottom, above the bed
  std::vector<AddedStack> stacks;   ///< by ascending id
  std::vector<std::string> warnings;  ///< for the job's report
  /// By object and layer of its part: where supports lie right below it.
  using Carried = std::map<std::pair<int32_t, int32_t>, MultiPolygon>;
  Carried carried;

  /// A stack without layers yet.
  AddedStack& Add(int32_t object, StackKind kind) {
    stacks.push_back({Stack(next_id++, object, kind), 0, {}});
    return stacks.back();
  }
};

/// Adds stacks that have layers of their own, before there are layers of the print. Planners run one
/// after the other, and each sees what those before it added; see JobPlanner for their order.
class RegionPlanner {
 public:
  virtual ~RegionPlanner() = default;

  /// `parts`: all layers, from the parts' own bottoms. Cancelled when `cancel` asks for it.
  virtual absl::Status Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                            RegionPlan& plan) = 0;
};

}  // namespace slicefarm::planning
