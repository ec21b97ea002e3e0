#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm::planning {

/// All solids on a plate that limit the supports of an object: parts, and supports that are already
/// planned.
class PlateSolids {
 public:
  /// All arguments must outlive this object.
  PlateSolids(std::span<const SlicedLayer> parts, std::span<const PlacedCopy> copies);

  /// Adds the supports of an object. `support` must outlive this object.
  void Add(const AddedStack& support);

  /// Returns the support problem of `object` in its own coordinates. It includes the solids within
  /// `clearance_nm` of any copy. Supports may extend beyond the object by at most `clearance_nm`,
  /// and by at most half of the gap between two copies. The bed of the problem is this area, as far
  /// as it is on `bed` for every copy. REQUIRES: the object has copies and layers. Cost:
  /// O(copies^2) boxes, and the points of near solids.
  SupportProblem ProblemOf(int32_t object, const MultiPolygon& bed, Coord clearance_nm);

 private:
  /// Stacks of an object and their outlines.
  struct Solid {
    std::vector<PartLayer> part;
    /// layers of the part and of each support stack, the part first
    std::vector<std::vector<SolidLayer>> stacks;
    Box box;
  };

  void AddAround(const Solid& object, const Solid& other, Point shift, Coord clearance_nm,
                 SupportProblem& problem);

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Solid> solids_;  ///< solids per object
  std::deque<MultiPolygon> moved_;   ///< moved outlines that problems refer to
};

}  // namespace slicefarm::planning
