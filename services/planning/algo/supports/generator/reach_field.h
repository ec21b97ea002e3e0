#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/planning/algo/supports/generator/raster.h"
#include "services/planning/algo/supports/generator/support_heights.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Consecutive layers of support that a branch passes in one step. Slabs are numbered from the bed
/// up.
struct Slab {
  int32_t first_layer = 0;  ///< first layer of support in the slab
  int32_t last_layer = 0;
  Coord bottom_nm = 0;
  Coord top_nm = 0;
  /// Square of the largest distance, in pixels, by which a branch may move from the slab above to
  /// this slab. It is a distance between pixel centres. The remainder of the allowed distance is
  /// added to the allowed distance of the slab above.
  int32_t step_squared = 0;

  Coord middle_nm() const { return (bottom_nm + top_nm) / 2; }
};

/// Groups the layers of support into slabs, bottom up. A slab is so high that a branch moves about
/// two pixels in it. `angle_rad`: largest lean of a branch from the vertical.
std::vector<Slab> SlabsOf(const SupportHeights& heights, double angle_rad, Coord pixel_nm);

/// Field of the points that branches can reach. It stores one number per pixel and slab: the radius
/// of the thickest branch with a valid path from there down to an end.
///
///   bed:      R_s = min(d_s, max of R_(s-1) within a step), R_0 = d_0.
///   anywhere: as for the bed, and R_s = d_s where a level enough piece of the part is right below.
///
/// R_s is the radius in slab s. d_s is the distance to the blocked area in the slab and slightly
/// above and below it, less the xy spacing. The part, other objects, and the area off the bed are
/// blocked. R_s depends only on the slab below, so one pass from the bed up computes the field.
/// Distances are limited to 7.7 mm (at 0.25 mm pixels).
///
/// Pixels are kPixelNm, or larger if the field would take over kMaxFieldBytes. Cost: about 5 ns per
/// pixel and slab, most of it on `threads` threads.
class ReachField {
 public:
  static constexpr Coord kPixelNm = 250'000;
  static constexpr int64_t kMaxFieldBytes = int64_t{192} << 20;

  /// Computes the field within `box`. Errors: Cancelled.
  static absl::StatusOr<ReachField> Make(const SupportProblem& problem,
                                         const SupportHeights& heights, const Box& box,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel);

  const PixelGrid& grid() const { return grid_; }
  const std::vector<Slab>& slabs() const { return slabs_; }

  /// Returns the radius of the thickest branch with a path from point `p` of a slab to the bed, in
  /// nm.
  Coord ToBed(size_t slab, Point p) const { return At(to_bed_, slab, p); }
  /// Returns the radius of the thickest branch with a path from point `p` of a slab to the bed or
  /// the part, in nm.
  Coord ToAnywhere(size_t slab, Point p) const {
    return to_part_.empty() ? ToBed(slab, p) : At(to_part_, slab, p);
  }
  /// Returns true if the part occupies the pixel at some height of the slab.
  bool OnPart(size_t slab, Point p) const { return part_[slab][Index(p)]; }
  /// Returns true if another object occupies the pixel in the slab, or the pixel is off the bed.
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
  std::vector<Plane> to_part_;  ///< empty if branches may end only on the bed
  std::vector<std::vector<bool>> part_;
  std::vector<std::vector<bool>> other_;  ///< other objects, and pixels off the bed
};

/// Returns for each pixel the maximum of `values` over the pixels within sqrt(step_squared) pixels.
/// Cost: O(pixels * step).
std::vector<PixelDistance> MostWithin(const std::vector<PixelDistance>& values,
                                      const PixelGrid& grid, int32_t step_squared);

}  // namespace slicefarm::planning
