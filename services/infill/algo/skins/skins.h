#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// What lies above and below a fill area: the outlines of the layers whose skins reach it. Pass the
/// same pointer for equal layers: equality with the fill area's own layer, or with the nearer one
/// before, is by pointer.
struct Cover {
  std::vector<const MultiPolygon*>
      above;  ///< nearest first, as many as top solid layers; nullptr: air
  std::vector<const MultiPolygon*>
      below;            ///< nearest first, as many as bottom solid layers; nullptr: air or bed
  bool on_bed = false;  ///< the area is in the lowest layer of its object
  /// Where only layers of the area's own region are `below`: the nearest ones of the whole object,
  /// which bear it. Empty: as `below`.
  std::vector<const MultiPolygon*> bearers = {};
};

struct SkinOptions {
  Coord width_nm = 450'000;         ///< of a solid bead: narrower regions join their neighbours
  double solid_below_area_mm2 = 0;  ///< smaller sparse regions become solid
  bool all_solid = false;           ///< no sparse region is wanted at all
  ShellThickness shells = ShellThickness::kEnabled;
  bool over_bridges = false;  ///< what lies over bridges is told apart; two bearers are needed
};

/// A partition of a fill area by what its infill is for.
struct Skins {
  MultiPolygon top;          ///< nothing above: the surface that is seen; no membranes over air
  MultiPolygon bridge;       ///< over air, and two beads of what bears it around that
  MultiPolygon bottom;       ///< over another region
  MultiPolygon over_bridge;  ///< over what is a bridge in the layer below
  MultiPolygon solid;        ///< the rest of the skins, or what is solid for other reasons
  MultiPolygon sparse;
};

/// Parts a fill area. A point belongs to the skins unless every outline of `cover` covers it; parts
/// that an outline leaves bare count if they are at least 0.3 of a bead wide (they go on under the
/// walls) and as large as a dot of a bead, and grow by two beads into the sparse region, so that
/// their lines end on something. With shells partial, at least three beads wide; with disabled,
/// only what a nearer outline still covers counts, a bead wide: slopes leave treads that are
/// narrower than a bead from one layer to the next, and stay sparse. Sparse places narrower than
/// four beads become solid as far as that from skins, as their lines would be bits. Narrow places
/// beside walls only stay sparse. What is too narrow for a bead beside a bridge joins it.
///
/// All is decided by widths, distances and areas: noise of some tens of nanometres in any operand
/// moves edges by as much, and dots where a width is just at its limit.
///
/// Invariant: the regions tile fill_area: disjoint, and with no gap, to rounding.
/// Cost: next to nothing for outlines that are `outline` (that of this layer) or do not come near
/// the fill area; two boolean operations for each other one, and one more for each kind of skin
/// there is.
Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options);

}  // namespace slicefarm::infill
