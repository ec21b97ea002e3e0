#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// Distance by which raft layers extend beyond the top layer, in nm, without the first layer.
inline constexpr Coord kRaftStepNm = 500'000;

/// One layer of a raft.
struct RaftLayer {
  Coord print_z_nm = 0;  ///< top of the layer above the bed
  Coord height_nm = 0;
  MultiPolygon region;
  RaftLayerKind kind = RaftLayerKind::kInterface;

  friend bool operator==(const RaftLayer&, const RaftLayer&) = default;
};

/// Returns the layers of a raft, from the bed up. `above`: area that the raft supports, of one
/// object or of several objects that share a raft: the footprints of the part's first layer and of
/// the supports that reach the bed. Holes stay open if they are wider than the expansion.
///
/// Heights: as in RaftHeights. The part's own first layer is layer_height thick (not
/// first_layer_height). The part gets neither a brim nor elephant foot compensation.
///
/// Layers: the upper (n + 1) / 2 of n layers are interface, the lower layers are base. B is
/// `above` grown by raft_expansion. The top layer is B. The lower layers are B grown by 0.5 mm,
/// because each layer supports the next one. The first layer is B grown by
/// raft_first_layer_expansion. A raft of one layer is B alone, as interface. Density and angle of
/// the lines: processes/fdm/settings/adhesion_rows.h.
///
/// Units: nm, in plate coordinates. Joins are round and distances are exact to 0.008 mm. Errors:
/// none. The result is empty if `above` is empty or the raft has no layers. Cost: three offsets.
/// Source: measured with PrusaSlicer 2.5.0 on a box of 20 mm and on spot.stl:
/// - Settings: raft_layers 1, 2, 3, 4, 5, 6; first_layer_height 0.2, 0.3, 0.35; layer_height 0.1,
///   0.2, 0.35; nozzle 0.4, 0.6; raft_contact_distance 0, 0.1, 0.25.
/// - Tops of the raft for first_layer_height 0.2, layer_height 0.2, nozzle 0.4 and distance 0.1:
///   0.2 | 0.5 | 0.8 | 1.1 | 1.4. The part's first layer ends at 0.5, 0.8, 1.1, 1.4, 1.7.
/// - Expansions with support_material_style snug: 1.5, 2.0 and 4.5 mm.
/// - With style grid PrusaSlicer rounds B up to a grid of about 3 mm, so a setting of 1.5 or 2 mm
///   gives 4.5 mm. slicefarm does not round.
std::vector<RaftLayer> RaftUnder(const MultiPolygon& above, const RaftOptions& options);

}  // namespace slicefarm::planning
