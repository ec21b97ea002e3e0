#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "common/stage/stages.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Rings [first, last) of a section's outline, numbered as in OutlineOf.
struct RingRange {
  int32_t first = 0;
  int32_t last = 0;
};

/// Plans the entry of each layer: the estimated end of the layer below, from the outlines. So
/// islands of an object, and copies on the plate, are printed in alternating order from layer to
/// layer.
///
/// An object's islands are visited by nearest neighbour in the object's own coordinates, without
/// regard to neighbouring objects. So the object's toolpaths do not depend on its position. Copies
/// are visited by nearest neighbour over their positions.
///
/// If a single copy is the whole print, two layers can meet at a seam without a retraction. This
/// needs a wall in the last island of the layer below that continues in the layer above. The upper
/// layer's planned seam on this wall must be near the lower layer's. Of several such seams the
/// nearest is taken. Layers that begin with supports are excluded. So the nozzle stays within the
/// part. The meeting point becomes the entry of the layer. The section's entry is kept for settings
/// without such meetings. Cost: O(points + islands^2) per section; O(copies^2) for each different
/// start of a layer (Beginning).
class TravelPlanner : public Planner {
 public:
  /// `copies` must outlive this planner.
  explicit TravelPlanner(std::span<const PlacedCopy> copies) : copies_(copies) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  /// Sets the meeting points of layers. Layers that were taken earlier are not changed. The travel
  /// from such a layer to the layer above is not changed either.
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Numbers of the objects with outlines in a layer, and the copy where the layer begins.
  using Beginning = std::pair<std::vector<int32_t>, int32_t>;

  int32_t LastCopy(const Beginning& beginning);
  int32_t NearestCopy(const std::vector<int32_t>& objects) const;

  const std::span<const PlacedCopy> copies_;
  /// point where the nozzle ends, per object, in the object's own coordinates
  std::map<int32_t, Point> left_at_;
  /// point where the nozzle ends on the plate; first the corner of the bed where the start G-code
  /// ends
  Point plate_left_at_;
  std::map<Beginning, int32_t> last_copies_;  ///< results of LastCopy, as a cache
  /// Rings of the island in which the nozzle probably ends each layer, indexed by layer. Only
  /// filled for a single copy.
  std::vector<RingRange> last_rings_;
  /// True for layers that begin with supports, indexed by layer. Only filled for a single copy.
  std::vector<bool> begins_with_support_;
};

}  // namespace slicefarm::planning
