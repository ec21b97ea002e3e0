#pragma once

#include <map>
#include <vector>

#include "services/planning/algo/planner/planner.h"
#include "services/planning/algo/seams/occupancy.h"
#include "services/planning/algo/seams/seam_candidates.h"
#include "services/planning/algo/seams/seam_costs.h"
#include "services/planning/algo/seams/seam_forest.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans the seam of each ring by the object's seam position.
///
/// With `nearest`, only layers with enforcers or blockers are planned, like with `aligned`; in all
/// other layers the ordering stage chooses the seams. With every other position the planner finds
/// possible points on each ring (seam_candidates.h). The planner computes the visibility
/// (occupancy.h) and the cost (seam_costs.h) of these points. Then it makes the cheapest choice
/// over the whole object (seam_forest.h) and straightens the lines of seams (seam_lines.h).
///
/// To limit the memory, the seams in the lower half of the layers are decided early if there are
/// more than `max_candidates` points. This decision uses all layers so far. Cost: O(n log n) per
/// layer for n outline points and possible points. Memory: about 100 bytes per possible point, with
/// one point for every two millimetres of outline, up to about 100 per ring.
class SeamPlanner : public Planner {
 public:
  static constexpr size_t kMaxCandidates = 4'000'000;

  /// `options` must outlive this planner.
  explicit SeamPlanner(const PlanningOptions& options, size_t max_candidates = kMaxCandidates)
      : options_(options), max_candidates_(max_candidates) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  int32_t Revise(OpenLayers& layers) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Ring of an object with its possible seams, and later its seam.
  struct Ring {
    int32_t layer = 0;  ///< index of the print's layer
    RingNumber number;
    Coord z_nm = 0;
    int32_t parent = -1;  ///< index in `rings` of the ring below that this ring continues; -1: none
    std::vector<SeamCandidate> candidates;
    SeamCandidate seam = {};  ///< chosen seam, once it is known
  };
  struct ObjectSeams {
    SeamCandidateFinder finder;
    Occupancy occupancy;
    /// Rings that are not finished (their seams are not in the plans yet), bottom up. Before them
    /// are the rings of the last finished layer, with only their seam as a possible point.
    std::vector<Ring> rings;
    size_t finished = 0;      ///< number of rings at the start of `rings` that are finished
    int32_t first_below = 0;  ///< index of the first ring of the layer below
  };

  bool IsPlanned(const ObjectSection& section) const;
  SeamPosition PositionOf(int32_t object) const;
  static std::vector<SeamNode> NodesOf(ObjectSeams& seams, SeamPosition position);
  /// Chooses and stores the seams of all rings in `seams`.
  static void Choose(ObjectSeams& seams, SeamPosition position);
  /// Chooses the seams of the rings below layer `end` and adds them to the plans. The choice uses
  /// the data of all layers so far.
  void FinishBelow(int32_t end, int32_t object, ObjectSeams& seams, OpenLayers& layers);
  static void Forget(size_t rings, ObjectSeams& seams);
  void Count(const std::vector<Ring>& rings, const Ring& ring);

  const PlanningOptions& options_;
  const size_t max_candidates_;
  size_t candidates_ = 0;  ///< number of possible points on rings that are not finished
  SeamQuality quality_;
  std::map<int32_t, ObjectSeams> objects_;  ///< seams per object
  int32_t layers_ = 0;                      ///< number of layers so far
};

}  // namespace slicefarm::planning
