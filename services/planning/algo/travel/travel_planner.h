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

/// Plans the entry point of each layer: the estimated end of the layer below, from the outlines. So
/// islands of an object, and copies on the plate, are printed in alternating order from layer to
/// layer.
///
/// The estimate visits an object's islands by nearest neighbour in the object's own coordinates,
/// without regard to neighbouring objects. So the object's toolpaths do not depend on its position.
/// The estimate visits copies by nearest neighbour over their positions.
///
/// If a single copy is the whole print, two layers can meet at a seam without a retraction. The
/// seam must be on a wall in the last island of the layer below, and the layer above must have a
/// seam within 0.3 mm of it. Of several such seams the one nearest to the entry is taken. Layers
/// that begin with supports are excluded. So the nozzle stays within the part. The meeting point
/// becomes the entry of the layer. The section's own entry does not change; it is used if the
/// settings do not allow such meetings. Cost: O(points + islands^2) per section; O(copies^2) for
/// each different start of a layer (Beginning).
class TravelPlanner : public Planner {
 public:
  /// `copies` must outlive this planner.
  explicit TravelPlanner(std::span<const PlacedCopy> copies) : copies_(copies) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  /// Sets the meeting points of layers, and marks both layers as joined. Layers that were taken
  /// earlier do not change, nor does the travel from such a layer to the layer above.
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Objects with outlines in a layer, and the index of the copy with which the layer begins.
  using Beginning = std::pair<std::vector<int32_t>, int32_t>;

  int32_t LastCopy(const Beginning& beginning);
  int32_t NearestCopy(const std::vector<int32_t>& objects) const;

  const std::span<const PlacedCopy> copies_;
  /// per object: point where the nozzle probably ends, in the object's own coordinates
  std::map<int32_t, Point> left_at_;
  /// point where the nozzle probably ends on the plate; at first the corner of the bed where the
  /// start G-code ends
  Point plate_left_at_;
  std::map<Beginning, int32_t> last_copies_;  ///< results of LastCopy, as a cache
  /// Rings of the island in which the nozzle probably ends each layer, indexed by layer. Only
  /// filled for a single copy.
  std::vector<RingRange> last_rings_;
  /// True for layers that begin with supports, indexed by layer. Only filled for a single copy.
  std::vector<bool> begins_with_support_;
};

}  // namespace slicefarm::planning
