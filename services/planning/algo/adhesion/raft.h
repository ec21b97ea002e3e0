#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// By how much a layer below another stands out.
inline constexpr Coord kRaftStepNm = 500'000;

struct RaftLayer {
  Coord print_z_nm = 0;  ///< its top
  Coord height_nm = 0;
  MultiPolygon region;
  RaftLayerKind kind = RaftLayerKind::kInterface;

  friend bool operator==(const RaftLayer&, const RaftLayer&) = default;
};

/// The layers of the raft under what stands on `carried`, from the bed up: under the part's first
/// layer and the supports that reach the bed, of one object or of several that share a raft. Holes
/// stay open where they are wider than the expansion leaves.
///
/// Heights: those of RaftHeights. The part's own first layer is layer_height thick (not
/// first_layer_height), and neither brim nor elephant foot compensation are applied to it.
///
/// Layers: of n the upper (n + 1) / 2 are interface, the others base. With B = `carried` grown by
/// raft_expansion, the top layer is B; the others B grown by 0.5 mm, as each layer carries the
/// next; the first B grown by raft_first_layer_expansion. A raft of one layer is B alone,
/// interface. Density and angle of the lines: common/config/table/adhesion_rows.h.
///
/// Units: nm, in plate coordinates; joins are round, distances exact to 0.008 mm.
/// Errors: none; no layers if there is nothing to carry, or none are asked for.
/// Cost: three offsets.
/// Source: measured, PrusaSlicer 2.5.0, raft_layers 1, 2, 3, 4, 5, 6; first_layer_height 0.2, 0.3,
/// 0.35; layer_height 0.1, 0.2, 0.35; nozzle 0.4, 0.6; raft_contact_distance 0, 0.1, 0.25; box of
/// 20 mm and spot.stl. Tops for 0.2/0.2/0.4 and 0.1: 0.2 | 0.5 | 0.8 | 1.1 | 1.4, part's first
/// layer ends at 0.5, 0.8, 1.1, 1.4, 1.7. Extents with support_material_style snug: 1.5, 2.0
/// and 4.5 mm. With style grid PrusaSlicer rounds B up to a grid of about 3 mm: 4.5 mm where 1.5
/// were asked for, and the same for 2. Not followed.
std::vector<RaftLayer> RaftUnder(const MultiPolygon& carried, const RaftOptions& options);

}  // namespace slicefarm::planning
