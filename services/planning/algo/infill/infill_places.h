#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Areas where a layer's sparse infill is left out, and areas where it is printed for several
/// layers.
struct InfillPlaces {
  MultiPolygon left_out;
  MultiPolygon combined;
  Coord combined_height_nm = 0;  ///< total height of the layers that `combined` is printed for
};

/// Applies infill_only_where_needed, from the top down. Infill is needed below solid infill wider
/// than `least_nm`, and below needed infill. The rest of `areas` is left out, together with a
/// margin of `margin_nm`. `areas` and `roofs`: one per layer, as from SparseAreas and RoofsOf.
void LeaveOutUnneeded(std::span<const MultiPolygon> areas, std::span<const MultiPolygon> roofs,
                      Coord least_nm, Coord margin_nm, std::span<InfillPlaces> places);

/// Applies infill_every_layers: groups that many layers, from the second layer up. The last layer
/// of a group prints the infill that all of them share, and the lower layers leave it out.
///
/// A strip of a layer within `least_nm` of the shared area is too narrow for lines of its own. In
/// the last layer the strip is printed with the shared area. In a lower layer the strip is left out
/// with it. On slopes both effects have about the same size.
void CombineLayers(const ObjectStack& stack, std::span<const MultiPolygon> areas,
                   int32_t every_layers, Coord least_nm, std::span<InfillPlaces> places);

}  // namespace slicefarm::planning
