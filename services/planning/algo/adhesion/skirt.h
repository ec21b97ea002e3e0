#pragma once

#include <cstdint>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/path.h"

namespace slicefarm::planning {

/// Returns the number of layers with a skirt, from the first layer: skirt_height, or all layers
/// with an enabled draft shield.
int32_t SkirtLayers(const SkirtOptions& options, int32_t layer_count);

/// Decides layer by layer, from the lowest up, whether the skirt reaches a layer. Layers that
/// contain supports only (OnlySupports) do not count, so the skirt continues through them.
class SkirtReach {
 public:
  /// `options` must outlive this object.
  explicit SkirtReach(const SkirtOptions& options) : options_(options) {}

  /// Returns true if the skirt reaches the next layer. For a layer that contains supports only,
  /// returns true if the skirt has not ended yet.
  bool Next(const SlicedLayer& layer);

  /// Returns the number of layers so far that count.
  int32_t layers() const { return layers_; }

 private:
  const SkirtOptions& options_;
  int32_t layers_ = 0;
};

/// Returns the loops of each skirt: one skirt around the convex hull of all parts and brims. With
/// `options.per_object`, each polygon of `parts` and `brims` has a skirt of its own, in this order;
/// polygons share one if their skirts meet. The outermost loop is first, so that the last one ends
/// near the parts, as in PrusaSlicer. All layers get the same loops.
///
/// The inner side of the innermost loop is `options.distance_nm` away from the hull of parts and
/// brims, with round corners. With a draft shield it is at this distance from the hull of the parts
/// alone. Further loops surround this loop at the bead's spacing. Loops are added until there are
/// `options.loops` of them and their filament on the first layer reaches `options.min_length_nm`,
/// up to limits::kMaxSkirtLoops. With options.start_angle_rad each loop begins in this direction
/// from the middle of the hull's box.
///
/// Shapes: `parts` has the outlines of the first `SkirtLayers` layers, supports and rafts included,
/// in any order. The outlines may overlap. Paths are closed, counter-clockwise, Feature::kSkirt,
/// object -1, with one width, and height 0 (the layer's). Units: nm, in plate coordinates.
/// Distances are exact to 0.008 mm. Errors: none. The result is empty if there are no parts, or if
/// lines of this width and height have no spacing. It is of no use after `cancel`. Cost: O(n log n)
/// for n points, and O(k) for a loop around k points of the hull. Source: measured with
/// PrusaSlicer 2.5.0, box of 20 mm, width 0.4, height 0.2 (spacing 0.357):
/// - Same in slicefarm: the order, round corners, loops 0.357 apart. min_skirt_length 20 gives 6
///   loops with a total of 22.3 mm of filament, and the same six on each layer of skirt_height.
/// - Same in slicefarm: skirts = 0 gives no loops, even with min_skirt_length or draft_shield.
/// - Same in slicefarm: with draft_shield limited or enabled, the distance is measured from the
/// part.
///   Brim lines that would overlap the shield are left out.
/// - Different: PrusaSlicer's first centre line is distance + spacing from the hull (6.357). So the
///   inner side is 0.157 farther out than skirt_distance says. In slicefarm the inner side is at
///   skirt_distance.
std::vector<std::vector<Path>> SkirtLoops(const MultiPolygon& parts, const MultiPolygon& brims,
                                          const SkirtOptions& options,
                                          const CancelToken& cancel = {});

/// Cuts the loops where their beads would leave the bed. A loop inside the bed is unchanged. The
/// remaining pieces of a cut loop are open lines, with the loop's direction and position in the
/// order. Cost: O(points of the loops * points of the bed).
std::vector<Path> WithinBed(std::vector<Path> loops, const MultiPolygon& bed);

/// Returns the ring-shaped area between the outer side of a draft shield's outermost loop and the
/// inner side of its innermost loop, for each of the skirts. Brims keep out of these areas. Empty
/// without a draft shield.
MultiPolygon ShieldKeepOut(const std::vector<std::vector<Path>>& skirts,
                           const SkirtOptions& options);

}  // namespace slicefarm::planning
