#pragma once

#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

/// Outlines of the layers above and below a fill area that its skins reach. An outline that is
/// equal to the outline of the fill area's own layer, or to the next nearer outline, must be the
/// same pointer: equality is tested by pointer.
struct Cover {
  std::vector<const MultiPolygon*>
      above;  ///< nearest first, as many as top solid layers; nullptr: air
  std::vector<const MultiPolygon*>
      below;            ///< nearest first, as many as bottom solid layers; nullptr: air or bed
  bool on_bed = false;  ///< the area is in the lowest layer of its object
  /// Outlines of the whole object in the layers below that support the area, nearest first. Used if
  /// `below` has only outlines of the area's own region; otherwise empty, and `below` is used.
  std::vector<const MultiPolygon*> bearers = {};
};

/// Options of the division into skins.
struct SkinOptions {
  /// Width of a solid bead; parts too narrow for it join their neighbours.
  Coord width_nm = 450'000;
  double solid_below_area_mm2 = 0;  ///< sparse parts with a smaller area become solid
  bool all_solid = false;           ///< true if the whole fill area becomes solid
  ShellThickness shells = ShellThickness::kEnabled;
  /// True if areas over bridges are a separate kind; `cover` then needs two layers in `bearers`.
  bool over_bridges = false;
};

/// Partition of a fill area by the purpose of its infill.
struct Skins {
  MultiPolygon top;          ///< visible surface with nothing above, without membranes over air
  MultiPolygon bridge;       ///< over air, plus two beads of the supporting area around it
  MultiPolygon bottom;       ///< over another region of the object
  MultiPolygon over_bridge;  ///< over a bridge of the layer below
  MultiPolygon solid;        ///< other skins, and areas that are solid for other reasons
  MultiPolygon sparse;
};

/// Divides a fill area into skins and sparse infill. A point belongs to the skins unless every
/// outline of `cover` covers it.
///
/// A part that an outline does not cover counts if it is at least 0.3 of a bead wide and as large
/// as a dot of a bead. The width may be so small because the part continues under the walls. Each
/// such part grows by two beads into the sparse region, so that its lines have supported ends. With
/// partial shells, parts that are not covered must be at least three beads wide. With disabled
/// shells, such a part counts only if a nearer outline still covers it and if it is a bead wide.
/// Slopes with steps narrower than a bead from layer to layer then stay sparse. Sparse parts
/// narrower than four beads become solid up to this distance from skins, because their lines would
/// be short bits. Narrow parts that are only beside walls stay sparse. A part beside a bridge that
/// is too narrow for a bead joins the bridge.
///
/// Only widths, distances and areas decide. Noise of some tens of nanometres in an operand
/// therefore moves edges by as much, and changes dots where a width is exactly at its limit.
///
/// Invariant: the regions tile fill_area: they are disjoint and have no gap, except for rounding.
/// Cost: almost none for outlines equal to `outline` (this layer's) or not near the fill area. Each
/// other outline costs two boolean operations, and each kind of skin in the result one more.
Skins PartFillArea(const MultiPolygon& fill_area, const MultiPolygon& outline, const Cover& cover,
                   const SkinOptions& options);

/// Returns the sparse part of the same partition, or nothing if it does not meet `wanted`. Cost:
/// that of PartFillArea without the kinds of skins; it stops at the first layer that takes all of
/// `wanted`.
MultiPolygon SparsePart(const MultiPolygon& fill_area, const MultiPolygon& outline,
                        const Cover& cover, const SkinOptions& options, const MultiPolygon& wanted);

}  // namespace slicefarm::infill
