#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Areas where a layer's sparse infill differs from the normal one.
struct InfillAreas {
  MultiPolygon left_out;  ///< area without infill
  MultiPolygon combined;  ///< area where this layer prints the infill of several layers
  /// height of the infill in `combined`: total height of the combined layers
  Coord combined_height_nm = 0;
};

/// Applies infill_only_where_needed, from the top down. Infill is needed below solid infill wider
/// than `least_nm`, and below needed infill. In each layer, the remaining part of `areas` is left
/// out. The left-out area extends by `margin_nm` beyond `areas`, to the part's outline. `areas` and
/// `roofs`: one per layer, as returned by SparseAreas and RoofsOf.
void LeaveOutUnneeded(std::span<const MultiPolygon> areas, std::span<const MultiPolygon> roofs,
                      Coord least_nm, Coord margin_nm, std::span<InfillAreas> infill_areas);

/// Applies infill_every_layers: groups `every_layers` layers, from the second layer up. The shared
/// area of a group is the area that has infill in all its layers. The last layer of a group prints
/// the infill of the shared area for all of them; the lower layers leave this area out.
///
/// A strip of a layer within `least_nm` of the shared area is too narrow for lines of its own. In
/// the last layer the strip is printed with the shared area. In a lower layer the strip is left out
/// with the shared area. On slopes both effects have about the same size.
void CombineLayers(const ObjectStack& stack, std::span<const MultiPolygon> areas,
                   int32_t every_layers, Coord least_nm, std::span<InfillAreas> infill_areas);

}  // namespace slicefarm::planning
