#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/path.h"

namespace slicefarm::planning {

/// On how many layers, from the first one, there is a skirt: skirt_height, or all with a draft
/// shield that is enabled.
int32_t SkirtLayers(const SkirtOptions& options, int32_t layer_count);

/// Which layers of a print a skirt reaches, told from the lowest up. It steps over layers of supports
/// alone (OnlySupports), which do not count.
class SkirtReach {
 public:
  /// `options` must outlive this.
  explicit SkirtReach(const SkirtOptions& options) : options_(options) {}

  /// Whether it reaches the next layer: stands on it or, of one of supports alone, passes it.
  bool Next(const SlicedLayer& layer);

  /// How many layers count so far.
  int32_t layers() const { return layers_; }

 private:
  const SkirtOptions& options_;
  int32_t layers_ = 0;
};

/// The loops of a skirt around the convex hull of everything, the outermost first, so that the last
/// one ends near the parts: PrusaSlicer's order. All layers get the same loops.
///
/// The first loop's inner edge runs `distance` from the hull of parts and brims (with a draft
/// shield: of the parts alone), with round corners; the next ones follow at the bead's spacing.
/// Loops are added until the filament that they take on the first layer reaches `min_length`, up to
/// limits::kMaxSkirtLoops.
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

/// The loops cut where their lines would leave the bed: a loop that stays within is as it was, what
/// is left of another are open lines, in its direction and at its place in the order. Cost:
/// O(points of the loops * points of the bed).
std::vector<Path> WithinBed(std::vector<Path> loops, const MultiPolygon& bed);

/// What a draft shield's loops cover, edge to edge: brims are cut by it. Empty without a shield.
MultiPolygon ShieldKeepOut(const std::vector<Path>& loops, const SkirtOptions& options);

}  // namespace slicefarm::planning
