#pragma once

#include <memory>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// Outlines of the layers above and below a fill area that decide its skins. Equality of outlines
/// is tested by pointer only. Therefore an outline must be the same pointer as an equal outline of
/// the fill area's own layer or of the next nearer layer.
struct Cover {
  std::vector<const MultiPolygon*> above;  ///< one per top solid layer, nearest first; nullptr: air
  std::vector<const MultiPolygon*>
      below;            ///< one per bottom solid layer, nearest first; nullptr: air or bed
  bool on_bed = false;  ///< true if the fill area is in the lowest layer of its object
  /// Outlines of the whole object in the layers below, nearest first, as supports of the area. Only
  /// needed if `below` contains only outlines of one region, or for SkinOptions::over_bridges. If
  /// empty, `below` is used.
  std::vector<const MultiPolygon*> bearers = {};
  /// outlines to which pointers above point, if they are no outlines of layers
  std::vector<std::shared_ptr<const MultiPolygon>> own = {};
};

/// Options of the division into skins.
struct SkinOptions {
  /// Width of a solid bead. Parts that are too narrow for it become part of a neighbouring area.
  Coord width_nm = 450'000;
  double solid_below_area_mm2 = 0;  ///< sparse parts with a smaller area become solid
  bool all_solid = false;           ///< true if the whole fill area becomes solid
  ShellThickness shells = ShellThickness::kEnabled;
  /// True if areas over bridges are a separate kind of area; Cover::bearers then needs two layers.
  bool over_bridges = false;
};

/// Partition of a fill area by the purpose of its infill.
struct Skins {
  /// visible surface without material above it; parts that are also over air are in `bridge`
  MultiPolygon top;
  MultiPolygon bridge;  ///< parts over air, plus two bead widths of the supporting area around them
  MultiPolygon bottom;  ///< parts over another region of the object
  MultiPolygon over_bridge;  ///< parts over a bridge of the layer below
  MultiPolygon solid;        ///< all other skins, and areas that are solid for other reasons
  MultiPolygon sparse;
};

/// Divides a fill area into skins and sparse infill. A point belongs to the sparse infill if all
/// outlines of `cover` cover it, else to the skins. `outline`: outline of the fill area's own
/// layer.
///
/// A part that an outline does not cover becomes a skin if it is at least 0.3 beads wide and as
/// large as a dot of a bead. The smallest width is below one bead because the part continues under
/// the walls. Each such part grows by two beads into the sparse region, so that its lines have
/// supported ends. With partial shells, the part must be at least three beads wide. With disabled
/// shells, the part must be a bead wide, and a nearer outline must still cover it. Slopes with
/// steps narrower than a bead from layer to layer then stay sparse.
///
/// Sparse parts narrower than four beads become solid within four beads from skins, because their
/// lines would be short. Narrow sparse parts farther away, beside walls only, stay sparse. A solid
/// part beside a bridge that is too narrow for a bead becomes part of the bridge.
///
/// Only widths, distances and areas decide. Noise of some tens of nanometres in an outline
/// therefore moves edges of the result by as much. If a width is exactly at its limit, the noise
/// may add or remove a dot.
///
/// Invariant: the regions tile fill_area: they are disjoint and have no gap, except for rounding.
/// Cost: almost none for outlines equal to `outline` or not near the fill area. Each other outline
/// costs two boolean operations, and each kind of skin in the result one more.
Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options);

/// Returns the sparse part that PartFillArea would return; empty if this part does not meet
/// `wanted`. Cost: as PartFillArea without the division of skins. The search ends at the first
/// layer that leaves no sparse part in `wanted`.
MultiPolygon SparsePart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                        const Cover& cover, const SkinOptions& options, const MultiPolygon& wanted);

}  // namespace slicefarm::infill
