#pragma once

#include <map>
#include <vector>

#include "services/planning/algo/planner/planner.h"
#include "services/planning/algo/seams/occupancy.h"
#include "services/planning/algo/seams/seam_costs.h"
#include "services/planning/algo/seams/seam_forest.h"
#include "services/planning/algo/seams/seam_places.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Where the walls of each ring start, by the object's seam position. `nearest`: nothing is
/// planned, so each layer decides, but for layers with enforcers or blockers, which are planned as
/// if `aligned` were asked for. Else: places on each ring (seam_places.h), what they cost
/// (seam_costs.h), how much is seen of them (occupancy.h), and of all the choice that costs least
/// over the whole object (seam_forest.h), in straight lines (seam_lines.h).
/// Where places come to more than `most_places`, the lower half of the layers is settled: with all
/// that is known by then, though not with what is still to come above.
/// Cost: O((points + places) * log places) a layer. Memory: about 100 bytes a place, of which there
/// are one for every two millimetres of outline, but about 100 on a ring.
class SeamPlanner : public Planner {
 public:
  static constexpr size_t kMostPlaces = 4'000'000;

  /// `options` must outlive this.
  explicit SeamPlanner(const PlanningOptions& options, size_t most_places = kMostPlaces)
      : options_(options), most_places_(most_places) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  int32_t Settle(OpenLayers& layers) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// A ring of the object, as a node of its forest.
  struct Ring {
    int32_t layer = 0;  ///< of the job's
    RingNumber number;
    Coord z_nm = 0;
    int32_t parent = -1;  ///< among the object's rings
    std::vector<SeamPlace> places;
    SeamPlace seam = {};  ///< the choice, once it is made
  };
  struct ObjectSeams {
    PlaceFinder finder;
    Occupancy occupancy;
    std::vector<Ring> rings;  ///< first those of the last settled layer, each with its seam alone
    size_t settled = 0;       ///< how many those are
    int32_t first_below = 0;  ///< of the rings of the layer below
  };

  bool IsPlanned(const ObjectSection& section) const;
  SeamPosition PositionOf(int32_t object) const;
  static std::vector<SeamNode> NodesOf(ObjectSeams& seams, SeamPosition position);
  /// Sets `seam` of all rings.
  static void Choose(ObjectSeams& seams, SeamPosition position);
  /// Chooses the seams of the rings below layer `end`, with a view to all.
  void SettleBelow(int32_t end, int32_t object, ObjectSeams& seams, OpenLayers& layers);
  static void Forget(size_t rings, ObjectSeams& seams);
  void Count(const std::vector<Ring>& rings, const Ring& ring);

  const PlanningOptions& options_;
  const size_t most_places_;
  size_t places_ = 0;  ///< of rings that are not settled
  SeamQuality quality_;
  std::map<int32_t, ObjectSeams> objects_;  ///< by object
  int32_t layers_ = 0;                      ///< seen
};

}  // namespace slicefarm::planning
