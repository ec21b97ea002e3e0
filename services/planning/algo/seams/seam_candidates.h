#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Possible point of a seam on a ring, with the properties that decide its cost.
struct SeamCandidate {
  Point at;
  float turn_rad = 0;  ///< change of direction at the point, see Bend::TurnRad (ring_shape.h)
  float overhang = 0;  ///< distance beyond the layer below, in multiples of the layer height
  /// distance from the outlines of the layer below, at most 2 mm; 0 without a layer below
  float away_mm = 0;
  uint8_t outward = 0;  ///< direction away from the solid, see Bend::Outward (ring_shape.h)
  /// Only for enforced points: distance along the ring from the middle of their section.
  float off_middle_mm = 0;
  bool enforced = false;
  bool blocked = false;
};

/// Returns true if the point is a corner: an inner corner of at least 15 degrees, or an outer
/// corner of at least 30 degrees.
bool IsCorner(const SeamCandidate& candidate);

/// Possible points of the seam on one ring of a layer.
struct RingCandidates {
  int32_t below = -1;  ///< index of the ring in the layer below that this ring continues; -1: none
  std::vector<SeamCandidate> candidates;  ///< in order of the length along the ring; at least one
};

/// Finds possible points for seams in the layers of one object, bottom up. The points are at
/// corners, and directly above the points of the layer below, so that seams can be vertical on any
/// wall. Further points, two millimetres apart, fill gaps, up to about a hundred per ring. In a
/// layer with painted enforcers or blockers, there may be four times as many. Memory: one layer.
class SeamCandidateFinder {
 public:
  /// Returns the possible points on the rings of the next section, in the order of ForEachRing.
  std::vector<RingCandidates> Next(const ObjectSection& section);

 private:
  struct Below {
    MultiPolygon outlines;
    RegionEdges edges;
    std::vector<RingCandidates> rings;
  };

  std::optional<Below> below_;
};

}  // namespace slicefarm::planning
