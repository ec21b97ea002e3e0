#pragma once

#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/measure.h"
#include "services/planning/algo/support/raster.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Between the edge of a step and a top under the next one: without it they would touch.
inline constexpr Coord kEdgeNm = 8'000;

/// Where support may be: off the part and the other objects, on the bed. Const and safe from any
/// thread.
///
/// A layer of support from b to t keeps xy_gap_nm from layers that share a height with it. It does
/// not lie under a layer whose bottom is less than top_gap_nm above t, nor over one whose top is
/// less than bottom_gap_nm below b. So on a slope the top lies at the distance asked for, upright,
/// under each step; to keep that distance from the steps' edges in space as well would leave steps
/// of half a millimetre without a top where it is asked for (README.md has figures).
class Clearance {
 public:
  /// For layers of support up to `top_nm`. `problem` and `options` must outlive it. Of no use once `cancel` says so.
  /// Cost: two offsets of each layer, on `threads` threads.
  Clearance(const SupportProblem& problem, const SupportOptions& options, Coord top_nm, int threads,
            const CancelToken& cancel = {});

  /// The part of `region` that is free for a layer of support from bottom_nm to top_nm.
  /// Cost: a boolean operation with the outlines near the region's box.
  MultiPolygon Free(const MultiPolygon& region, Coord bottom_nm, Coord top_nm) const;
  /// The same of all that rings wind around, which may overlap.
  MultiPolygon FreeOf(std::span<const Polygon> rings, Coord bottom_nm, Coord top_nm) const;
  /// Sets the pixels that are not free for such a layer.
  void FillBlocked(Coord bottom_nm, Coord top_nm, Bitmap& bitmap) const;

 private:
  struct Layer {
    SolidLayer solid;
    Box box;              ///< of the outlines
    MultiPolygon spaced;  ///< grown by xy_gap_nm
    MultiPolygon edged;   ///< grown by kEdgeNm
  };
  using Stack = std::vector<Layer>;

  /// Calls visit(outlines) with what is not free, of layers that meet the box.
  template <typename Visit>
  void ForEachBlocked(Coord bottom_nm, Coord top_nm, const Box& box, Visit visit) const;
  MultiPolygon OnBed(MultiPolygon free, const Box& bounds) const;

  const SupportProblem& problem_;
  const SupportOptions& options_;
  Box bed_;
  std::vector<Stack> stacks_;
};

}  // namespace slicefarm::planning
