#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Names in the comments are the settings' (PrusaSlicer's).
struct RaftOptions {
  int32_t layers = 0;                          ///< raft_layers; 0: no raft
  Coord contact_distance_nm = 100'000;         ///< raft_contact_distance
  Coord expansion_nm = 1'500'000;              ///< raft_expansion
  Coord first_layer_expansion_nm = 3'000'000;  ///< raft_first_layer_expansion, beyond the former
  double first_layer_density = 0.9;            ///< raft_first_layer_density
  Coord first_layer_height_nm = 200'000;  ///< first_layer_height: the raft's, no longer the part's
  Coord layer_height_nm = 200'000;        ///< layer_height
  Coord nozzle_diameter_nm = 400'000;     ///< of the support's tool
  Coord line_width_nm = 400'000;          ///< support_material_extrusion_width
  Coord base_spacing_nm = 2'500'000;      ///< support_material_spacing: free between base lines
  double angle_rad = 0;                   ///< support_material_angle

  friend bool operator==(const RaftOptions&, const RaftOptions&) = default;
};

struct RaftLayer {
  Coord print_z_nm = 0;  ///< its top
  Coord height_nm = 0;
  MultiPolygon region;
  double density = 1;      ///< of lines: 1 is solid
  double angle_rad = 0;    ///< of lines
  bool interface = false;  ///< Support material interface, else Support material

  friend bool operator==(const RaftLayer&, const RaftLayer&) = default;
};

struct Raft {
  std::vector<RaftLayer> layers;  ///< from the bed up
  Coord part_shift_nm = 0;        ///< the part's bottom: the raft's top and the contact distance

  friend bool operator==(const Raft&, const Raft&) = default;
};

/// The raft under what stands on `carried`: the part's first layer and the supports that reach the
/// bed, of one object or of several that share a raft. Holes stay open where they are wider than
/// the expansion leaves.
///
/// Heights: the first layer has first_layer_height, all others max(layer_height, 3/4 of the
/// nozzle). The part's bottom is contact_distance above the last one's top, its own first layer is
/// layer_height thick (not first_layer_height), and neither brim nor elephant foot compensation are
/// applied to it.
///
/// Layers: of n the upper (n + 1) / 2 are interface, the others base. With B = `carried` grown by
/// raft_expansion, the top layer is B; the others B grown by 0.5 mm, as each layer carries the
/// next; the first B grown by raft_first_layer_expansion. A raft of one layer is B alone,
/// interface.
///
///   layer            density                          lines run at support_material_angle
///   first            raft_first_layer_density         + 90 degrees if there are two base layers
///   other base       width / (width + base_spacing)
///   interface        1                                + 90 degrees
///
/// Units: nm, in plate coordinates; joins are round, distances exact to 0.008 mm.
/// Errors: none; no layers if there is nothing to carry, or none are asked for.
/// Cost: three offsets.
/// Source: measured, PrusaSlicer 2.5.0, raft_layers 1, 2, 3, 4, 5, 6; first_layer_height 0.2, 0.3,
/// 0.35; layer_height 0.1, 0.2, 0.35; nozzle 0.4, 0.6; raft_contact_distance 0, 0.1, 0.25; box of
/// 20 mm and spot.stl. Tops for 0.2/0.2/0.4 and 0.1: 0.2 | 0.5 | 0.8 | 1.1 | 1.4, part's first
/// layer ends at 0.5, 0.8, 1.1, 1.4, 1.7. Extents with support_material_style snug: 1.5, 2.0
/// and 4.5 mm. With style grid PrusaSlicer rounds B up to a grid of about 3 mm: 4.5 mm where 1.5
/// were asked for, and the same for 2. Not followed. Its snug style turns the topmost interface by
/// 45 degrees: not followed. It lays interfaces of height 0.3 at the spacing of lines of
/// layer_height, 6 % too little plastic: density 1 is meant to fill here.
Raft RaftUnder(const MultiPolygon& carried, const RaftOptions& options);

}  // namespace slicefarm::planning
