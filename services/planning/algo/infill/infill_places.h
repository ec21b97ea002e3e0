#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// What a layer's sparse infill leaves out, and what it prints for several layers.
struct InfillPlaces {
  MultiPolygon left_out;
  MultiPolygon combined;
  Coord combined_height_nm = 0;  ///< of all the layers for which `combined` is printed
};

/// infill_only_where_needed: from the top down, infill is needed below solid infill that is wider
/// than `least_nm`, and below infill. All else of `areas` is left out, and what `margin_nm` around
/// them belongs to them. `areas` and `roofs`: as SparseAreas and RoofsOf give them, one a layer.
void LeaveOutUnneeded(std::span<const MultiPolygon> areas, std::span<const MultiPolygon> roofs,
                      Coord least_nm, Coord margin_nm, std::span<InfillPlaces> places);

/// infill_every_layers: stretches of so many layers, from the second layer up, in which the last
/// one prints what all of them share, and the others leave it out. What a layer has besides, but
/// no further than `least_nm` from that, has no room for lines of its own: it belongs to what the
/// last layer prints, or is left out with it. On slopes the one is as much as the other.
void CombineLayers(const ObjectStack& stack, std::span<const MultiPolygon> areas,
                   int32_t every_layers, Coord least_nm, std::span<InfillPlaces> places);

}  // namespace slicefarm::planning
