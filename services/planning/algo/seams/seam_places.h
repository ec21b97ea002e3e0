#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// Place on a ring for a possible seam, with the properties that decide about it.
struct SeamPlace {
  Point at;
  float turn_rad = 0;   ///< turn as in Bend::TurnRad
  float overhang = 0;   ///< distance beyond the layer below, in heights of the layer
  float away_mm = 0;    ///< distance from the outlines of the layer below; 0 without a layer below
  uint8_t outward = 0;  ///< direction as in Bend::Outward
  /// Distance along the ring from the middle of the run of enforced places.
  float off_middle_mm = 0;
  bool enforced = false;
  bool blocked = false;
};

/// Returns true if the place is a corner: an inner corner from 15 degrees on, or an outer one from
/// 30.
bool IsCorner(const SeamPlace& place);

/// Places on one outline of a layer.
struct RingPlaces {
  int32_t below =
      -1;  ///< index of the ring that it continues in the layer below; -1: none
  std::vector<SeamPlace> places;  ///< in order of the length along the ring; at least one
};

/// Finds places for seams, going up the layers of one object. Places are at corners and straight
/// above the places of the layer below, so that seams can be upright on any wall. Further places
/// fill gaps, two millimetres apart, up to about a hundred per ring. Painted parts have four times
/// as many. Memory: one layer.
class PlaceFinder {
 public:
  /// Returns the places on the rings of the next section, in the order of ForEachRing.
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
