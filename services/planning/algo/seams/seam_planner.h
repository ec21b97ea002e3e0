#pragma once

#include <map>
#include <vector>

#include "common/model/planning_options.h"
#include "services/planning/algo/planner.h"
#include "services/planning/algo/seams/occupancy.h"
#include "services/planning/algo/seams/seam_costs.h"
#include "services/planning/algo/seams/seam_forest.h"
#include "services/planning/algo/seams/seam_places.h"

namespace slicefarm::planning {

/// Where the walls of each ring start, by the object's seam position. `nearest`: nothing is
/// planned, so each layer decides. Else: places on each ring (seam_places.h), what they cost
/// (seam_costs.h), how much is seen of them (occupancy.h), and of all the choice that costs least
/// over the whole object (seam_forest.h).
/// Cost: O(points + places * places) a layer. Memory: places of all layers, about 100 bytes for
/// each millimetre of outline, but at most 10 kB a ring.
class SeamPlanner : public Planner {
 public:
  /// `options` must outlive this.
  explicit SeamPlanner(const PlanningOptions& options) : options_(options) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, JobPlan& plan) override;

 private:
  /// A ring of the object, as a node of its forest.
  struct Ring {
    int32_t layer = 0;  ///< of the job's
    RingNumber number;
    Coord z_nm = 0;
    int32_t parent = -1;  ///< among the object's rings
    std::vector<SeamPlace> places;
  };
  struct ObjectSeams {
    PlaceFinder finder;
    Occupancy occupancy;
    std::vector<Ring> rings;
    int32_t first_below = 0;  ///< of the rings of the layer below
  };

  SeamPosition PositionOf(int32_t object) const {
    return options_.objects[static_cast<size_t>(object)].seam;
  }
  static std::vector<SeamNode> NodesOf(ObjectSeams& seams, SeamPosition position);
  static void Count(const std::vector<Ring>& rings, const std::vector<int32_t>& chosen,
                    SeamQuality& quality);

  const PlanningOptions& options_;
  std::map<int32_t, ObjectSeams> objects_;  ///< by object
  int32_t layers_ = 0;                      ///< seen
};

}  // namespace slicefarm::planning
