#pragma once

#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/measure.h"
#include "services/planning/algo/supports/generator/raster.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Horizontal gap in nm between the side of a part's step and the top of a support under the next
/// step. Without the gap they would touch.
inline constexpr Coord kEdgeNm = 8'000;

/// Computes the free area for supports: on the bed, and away from the part and the other objects.
/// Const methods are safe from any thread.
///
/// Obstacles are the layers of the part and of other objects. A layer of support from height b to
/// height t keeps xy_gap_nm sideways from obstacles that share a height with it. The layer of
/// support is not below an obstacle with a bottom less than top_gap_nm above t. It is not above an
/// obstacle with a top less than bottom_gap_nm below b. So on a slope, the top of a support has the
/// requested vertical distance under each step of the part. A rule that also required this distance
/// sideways from each step would leave steps of half a millimetre without a support at the
/// requested distance (README.md has figures).
class Clearance {
 public:
  /// Computes the obstacles for layers of support up to the height `top_nm`. `problem` and
  /// `options` must outlive this object. The object is unusable after a cancellation. Cost: two
  /// offsets of each layer, on `threads` threads.
  Clearance(const SupportProblem& problem, const SupportOptions& options, Coord top_nm, int threads,
            const CancelToken& cancel = {});

  /// Returns the part of `region` that is free for a layer of support from bottom_nm to top_nm.
  /// Cost: a boolean operation with the outlines near the region's box.
  MultiPolygon Free(const MultiPolygon& region, Coord bottom_nm, Coord top_nm) const;
  /// Returns the free part of the area inside the rings, which may overlap (nonzero rule), for a
  /// layer of support from bottom_nm to top_nm.
  MultiPolygon FreeOf(std::span<const Polygon> rings, Coord bottom_nm, Coord top_nm) const;
  /// Sets the pixels that are not free for a layer of support from bottom_nm to top_nm.
  void FillBlocked(Coord bottom_nm, Coord top_nm, Bitmap& bitmap) const;

 private:
  struct Layer {
    SolidLayer solid;
    Box box;              ///< box of the outlines
    MultiPolygon spaced;  ///< outlines grown by xy_gap_nm
    MultiPolygon edged;   ///< outlines grown by kEdgeNm
  };
  using Stack = std::vector<Layer>;

  /// Calls visit(outlines) for each obstacle in the box that blocks a layer of support from
  /// bottom_nm to top_nm. `outlines`: the area that the obstacle blocks; it may reach beyond the
  /// box.
  template <typename Visit>
  void ForEachBlocked(Coord bottom_nm, Coord top_nm, const Box& box, Visit visit) const;
  MultiPolygon OnBed(MultiPolygon free, const Box& bounds) const;

  const SupportProblem& problem_;
  const SupportOptions& options_;
  Box bed_;
  std::vector<Stack> stacks_;
};

}  // namespace slicefarm::planning
