#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Possible point of a seam on a ring, with the properties that decide about it.
struct SeamPlace {
  Point at;
  float turn_rad = 0;   ///< change of direction as in Bend::TurnRad
  float overhang = 0;   ///< distance beyond the layer below, in multiples of the layer height
  float away_mm = 0;    ///< distance from the outlines of the layer below; 0 without a layer below
  uint8_t outward = 0;  ///< direction as in Bend::Outward
  /// Distance along the ring from the middle of the section of enforced points.
  float off_middle_mm = 0;
  bool enforced = false;
  bool blocked = false;
};

/// Returns true if the point is a corner: an inner corner of at least 15 degrees, or an outer
/// corner of at least 30 degrees.
bool IsCorner(const SeamPlace& place);

/// Possible points of the seam on one outline of a layer.
struct RingPlaces {
  int32_t below = -1;  ///< index of the ring in the layer below that this ring continues; -1: none
  std::vector<SeamPlace> places;  ///< in order of the length along the ring; at least one
};

/// Finds possible points for seams, going up the layers of one object. Points are at corners and
/// straight above the points of the layer below, so that seams can be vertical on any wall. Further
/// points fill gaps, two millimetres apart, up to about a hundred per ring. Painted parts have four
/// times as many. Memory: one layer.
class PlaceFinder {
 public:
  /// Returns the possible points on the rings of the next section, in the order of ForEachRing.
  std::vector<RingPlaces> Next(const ObjectSection& section);

 private:
  struct Below {
    MultiPolygon outlines;
    RegionEdges edges;
    std::vector<RingPlaces> rings;
  };

  std::optional<Below> below_;
};

}  // namespace slicefarm::planning
