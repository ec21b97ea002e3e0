#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/planning/algo/rings/region_edges.h"

namespace slicefarm::planning {

/// A place on a ring where its seam may be, and what speaks for and against it.
struct SeamPlace {
  Point at;
  float turn_rad = 0;     ///< Bend::TurnRad
  float overhang = 0;     ///< how far it hangs over the layer below, in heights of the layer
  float away_mm = 0;      ///< how far from the outlines of the layer below; 0 without one
  uint8_t outward = 0;    ///< Bend::Outward
  float off_middle_mm = 0;  ///< along the ring, from the middle of the run of enforced places
  bool enforced = false;
  bool blocked = false;
};

/// Corners that count as such: inner ones from 15 degrees on, outer ones from 30.
bool IsCorner(const SeamPlace& place);

/// An outline of a layer.
struct RingPlaces {
  int32_t below =
      -1;  ///< the ring of the layer below that it continues: its number there; -1: none
  std::vector<SeamPlace> places;  ///< by length along the ring; one at least
};

/// Goes up the layers of one object and finds places for seams: corners, places straight above
/// those of the layer below, so that seams can stand upright on any wall, and others where there
/// are no such, two millimetres apart, no more than about a hundred on a ring. Where the part is
/// painted, four times as many. Memory: of one layer.
class PlaceFinder {
 public:
  /// The rings of the next section, by the order of ForEachRing.
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
