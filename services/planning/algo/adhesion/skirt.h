#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::planning {

/// How far up a skirt stands as a wall against draft, and what it keeps its distance from.
enum class DraftShield {
  kDisabled,  ///< a skirt on the first layers, outside of the brims
  kLimited,   ///< as high as a skirt, but close to the parts: brims give way to it
  kEnabled,   ///< the same on all layers
};

/// Names in the comments are the settings' (PrusaSlicer's).
struct SkirtOptions {
  int32_t loops = 1;              ///< skirts; 0: none, whatever else is asked for
  Coord distance_nm = 6'000'000;  ///< skirt_distance: to the inner edge of the first line
  Coord min_length_nm = 0;        ///< min_skirt_length: of filament, on one layer
  int32_t height_layers = 1;      ///< skirt_height
  DraftShield draft_shield = DraftShield::kDisabled;  ///< draft_shield
  Coord width_nm = 400'000;             ///< of a line over all: first_layer_extrusion_width
  Coord height_nm = 200'000;            ///< of the first layer
  double filament_area_mm2 = 2.405282;  ///< section of the filament: 1.75 mm across

  friend bool operator==(const SkirtOptions&, const SkirtOptions&) = default;
};

/// No skirt has more loops than this, whatever length is asked for.
inline constexpr int32_t kMaxSkirtLoops = 500;

/// On how many layers, from the first one, there is a skirt: skirt_height, or all with a draft
/// shield that is enabled.
int32_t SkirtLayers(const SkirtOptions& options, int32_t layer_count);

/// The loops of a skirt around the convex hull of everything, the outermost first, so that the last
/// one ends near the parts: PrusaSlicer's order. All layers get the same loops.
///
/// The first loop's inner edge runs `distance` from the hull of parts and brims (with a draft
/// shield: of the parts alone), with round corners; the next ones follow at the bead's spacing.
/// Loops are added until the filament that they take on the first layer reaches `min_length`.
///
/// Shapes: `parts` is what is printed on the layers concerned, supports and rafts included: the
/// first `SkirtLayers` layers' outlines, in any order, overlapping or not. Paths are closed,
/// counter-clockwise, Feature::kSkirt, object -1, one width, height 0 (the layer's).
/// Units: nm, in plate coordinates. Distances are exact to 0.008 mm.
/// Errors: none; no loops if there is nothing to go round, or if lines of this width and height
/// have no spacing.
/// Cost: O(n log n), n points, and O(k) for a loop around k points of the hull.
/// Source: measured, PrusaSlicer 2.5.0, box of 20 mm, width 0.4, height 0.2 (spacing 0.357):
/// - order, round corners, loops 0.357 apart, min_skirt_length 20 gives 6 loops of 22.3 mm in sum,
///   and these six on each layer of skirt_height: as here;
/// - skirts = 0 gives none, with min_skirt_length or draft_shield either: as here;
/// - draft_shield limited and enabled: distance from the part, brim lines in the way left out;
/// - its first centre line is distance + spacing from the hull (6.357), so the inner edge is 0.157
///   farther out than skirt_distance says. Here it is where the setting says.
std::vector<Path> SkirtLoops(const MultiPolygon& parts, const MultiPolygon& brims,
                             const SkirtOptions& options);

/// What a draft shield's loops cover, edge to edge: brims are cut by it. Empty without a shield.
MultiPolygon ShieldKeepOut(const std::vector<Path>& loops, const SkirtOptions& options);

}  // namespace slicefarm::planning
