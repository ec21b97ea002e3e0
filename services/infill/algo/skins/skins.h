#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// Outlines of the layers above and below a fill area that its skins reach. Pass the same pointer
/// for equal layers: equality with the fill area's own layer, or with the previous nearer layer, is
/// tested by pointer.
struct Cover {
  std::vector<const MultiPolygon*>
      above;  ///< nearest first, as many as top solid layers; nullptr: air
  std::vector<const MultiPolygon*>
      below;            ///< nearest first, as many as bottom solid layers; nullptr: air or bed
  bool on_bed = false;  ///< the area is in the lowest layer of its object
  /// Nearest layers of the whole object, which support the area. Used if `below` has only layers of
  /// the area's own region; otherwise empty, and `below` is used.
  std::vector<const MultiPolygon*> bearers = {};
};

/// Options of the division into skins.
struct SkinOptions {
  Coord width_nm = 450'000;  ///< width of a solid bead; narrower regions join their neighbours
  double solid_below_area_mm2 = 0;  ///< smaller sparse regions become solid
  bool all_solid = false;           ///< there is no sparse region at all
  ShellThickness shells = ShellThickness::kEnabled;
  bool over_bridges = false;  ///< areas over bridges are a separate kind, which needs two bearers
};

/// Partition of a fill area by the purpose of its infill.
struct Skins {
  MultiPolygon top;          ///< visible surface with nothing above, without membranes over air
  MultiPolygon bridge;       ///< over air, plus two beads of the supporting area around it
  MultiPolygon bottom;       ///< over another region
  MultiPolygon over_bridge;  ///< over a bridge of the layer below
  MultiPolygon solid;        ///< the rest of the skins, and areas that are solid for other reasons
  MultiPolygon sparse;
};

/// Divides a fill area into skins and sparse infill. A point belongs to the skins unless every
/// outline of `cover` covers it.
///
/// A part that an outline does not cover counts if it is at least 0.3 of a bead wide and as large
/// as a dot of a bead. The width may be so small because the part continues under the walls. Each
/// such part grows by two beads into the sparse region, so that its lines have supported ends. With
/// partial shells, such parts must be at least three beads wide. With disabled shells, only a part
/// that a nearer outline still covers counts, if it is a bead wide. Slopes with treads narrower
/// than a bead from layer to layer then stay sparse. Sparse parts narrower than four beads become
/// solid up to this distance from skins, because their lines would be short bits. Narrow parts that
/// are only beside walls stay sparse. A part beside a bridge that is too narrow for a bead joins
/// the bridge.
///
/// Only widths, distances and areas decide: noise of some tens of nanometres in an operand moves
/// edges by as much, and changes dots where a width is exactly at its limit.
///
/// Invariant: the regions tile fill_area: they are disjoint and have no gap, except for rounding.
/// Cost: almost none for outlines equal to `outline` (this layer's) or not near the fill area. Each
/// other outline costs two boolean operations, and each kind of skin in the result one more.
Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options);

/// Returns the sparse part of the same partition, or nothing if it does not meet `wanted`. Cost: that of
/// PartFillArea without the kinds of skins; it stops at the first layer that takes all of `wanted`.
MultiPolygon SparsePart(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                        const SkinOptions& options, const MultiPolygon& wanted);

}  // namespace slicefarm::infill
