#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/support/raster.h"
#include "services/planning/algo/support/support_heights.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Consecutive layers of support that branches pass in one step.
struct Slab {
  int32_t first_layer = 0;  ///< of support
  int32_t last_layer = 0;
  Coord bottom_nm = 0;
  Coord top_nm = 0;
  /// How far, in squared pixels, a branch may go from the slab above (in this one) to here: the
  /// pixels in a disc. What the angle allows and whole pixels do not is carried over to the next.
  int32_t step_squared = 0;

  Coord middle_nm() const { return (bottom_nm + top_nm) / 2; }
};

/// Layers in slabs of about two pixels' way, upwards.
std::vector<Slab> SlabsOf(const SupportHeights& heights, double angle_rad, Coord pixel_nm);

/// Where branches can go, as one number for each place and slab: the radius of the thickest branch
/// that gets from there to where it may end.
///
///   bed:     R_s = min(d_s, max of R_(s-1) within a step), R_0 = d_0
///   anywhere: the same, and d_s where a level enough piece of the part lies right below
///
/// d_s is the distance to what is not free in the slab (and a little above and below it): the part
/// and others, and off the bed, less the xy spacing. So one sweep answers for all radii.
/// Distances beyond 7.7 mm (at 0.25 mm pixels) count as that.
///
/// Pixels are kPixelNm, or more where the field would take over kMaxFieldBytes.
/// Cost: about 5 ns for a pixel and slab, most of it on `threads` threads.
class ReachField {
 public:
  static constexpr Coord kPixelNm = 250'000;
  static constexpr int64_t kMaxFieldBytes = int64_t{192} << 20;

  /// Errors: Cancelled.
  static absl::StatusOr<ReachField> Make(const SupportProblem& problem,
                                         const SupportHeights& heights, const Box& box,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

  const PixelGrid& grid() const { return grid_; }
  const std::vector<Slab>& slabs() const { return slabs_; }

  /// Radii, nm, at the pixel of a place.
  Coord ToBed(size_t slab, Point p) const { return At(to_bed_, slab, p); }
  Coord ToAnywhere(size_t slab, Point p) const {
    return to_part_.empty() ? ToBed(slab, p) : At(to_part_, slab, p);
  }
  /// What is in the way at the pixel itself, somewhere in the slab's height.
  bool OnPart(size_t slab, Point p) const { return part_[slab][Index(p)]; }
  bool OnOther(size_t slab, Point p) const { return other_[slab][Index(p)]; }

 private:
  using Plane = std::vector<PixelDistance>;

  size_t Index(Point p) const {
    return static_cast<size_t>(grid_.Row(p.y)) * grid_.width + grid_.Column(p.x);
  }
  Coord At(const std::vector<Plane>& planes, size_t slab, Point p) const {
    return planes[slab][Index(p)] * grid_.pixel_nm / kDistanceSteps;
  }

  PixelGrid grid_;
  std::vector<Slab> slabs_;
  std::vector<Plane> to_bed_;
  std::vector<Plane> to_part_;  ///< empty where branches may end on the bed alone
  std::vector<std::vector<bool>> part_;
  std::vector<std::vector<bool>> other_;  ///< and what is not on the bed
};

/// max over the pixels within sqrt(step_squared) of each. Cost: O(pixels * step).
std::vector<PixelDistance> MostWithin(const std::vector<PixelDistance>& values,
                                      const PixelGrid& grid, int32_t step_squared);

}  // namespace slicefarm::planning
