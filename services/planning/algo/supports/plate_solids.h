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
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm::planning {

/// All that stands on a plate, as supports of one object see it.
class PlateSolids {
 public:
  /// All must outlive this.
  PlateSolids(std::span<const SlicedLayer> parts, std::span<const PlacedCopy> copies);

  /// Of an object that supports were added to. `support` must outlive this.
  void Add(const AddedStack& support);

  /// What is to be supported of `object`, in its own coordinates, with what stands within `room_nm`
  /// of it around any of its copies; the bed is what all of them have of `bed` there.
  /// REQUIRES: the object has copies and layers. Cost: O(copies^2) boxes, and the points of what is
  /// near.
  SupportProblem ProblemOf(int32_t object, const MultiPolygon& bed, Coord room_nm);

 private:
  /// An object's stacks and what they cover.
  struct Solid {
    std::vector<PartLayer> part;
    std::vector<std::vector<SolidLayer>> stacks;  ///< the part's too
    Box box;
  };

  void AddAround(const Solid& object, const Solid& other, Point shift, Coord room_nm,
                 SupportProblem& problem);

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Solid> solids_;  ///< by object
  std::deque<MultiPolygon> moved_;   ///< what problems refer to
};

}  // namespace slicefarm::planning
