#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "common/stage/stages.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Rings [first, last) of a section's outline, as OutlineOf numbers them.
struct RingRange {
  int32_t first = 0;
  int32_t last = 0;
};

/// Where each layer is entered: where the one before ends, as far as outlines tell. So islands of
/// an object, and copies on the plate, are printed to and fro from layer to layer.
///
/// An object's islands are visited by nearest neighbour in the object's own coordinates, whatever
/// stands around it: its toolpaths are the same wherever it stands. Copies are visited by nearest
/// neighbour over their places.
///
/// Where a single copy is all that is printed, and a wall goes on from the island where the layer
/// below ends (a planned seam near to one there), layers meet at its seam with the filament ready:
/// of several such seams at the nearest one. Not where supports come first. So the nozzle goes on within the part. The layer's entry
/// is the meeting then; that of the section stays, for settings by which layers do not meet.
/// Cost: O(points + islands^2) a section; O(copies^2) for each way in which layers begin.
class TravelPlanner : public Planner {
 public:
  /// `copies` must outlive this.
  explicit TravelPlanner(std::span<const PlacedCopy> copies) : copies_(copies) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  /// Layers that were taken before are left as they are, and so is the way to the one above them.
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Objects with outlines in a layer, by number, and the copy where the layer begins.
  using Beginning = std::pair<std::vector<int32_t>, int32_t>;

  int32_t LastCopy(const Beginning& beginning);
  int32_t NearestCopy(const std::vector<int32_t>& objects) const;

  const std::span<const PlacedCopy> copies_;
  std::map<int32_t, Point> left_at_;       ///< by object, in its own coordinates
  Point plate_left_at_;                    ///< at first the corner of the bed, where start G-code ends
  std::map<Beginning, int32_t> last_copies_;  ///< known answers
  /// By layer, of the island where the only copy is likely to be left; none if there are several.
  std::vector<RingRange> last_rings_;
  std::vector<bool> begins_with_support_;  ///< by layer, with a single copy
};

}  // namespace slicefarm::planning
