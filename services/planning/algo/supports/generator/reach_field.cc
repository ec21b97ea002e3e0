#include "services/planning/algo/supports/generator/reach_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/parallel.h"
#include "common/base/portable_math.h"
#include "common/model/options/support_options.h"

namespace slicefarm::planning {
namespace {

/// Sideways movement of a branch within a slab, in pixels.
constexpr double kPixelsInSlab = 2.2;
/// Distance above and below a slab within which obstacles also count, because a branch leans
/// between the middles of two slabs.
constexpr Coord kOverlapNm = 150'000;
/// Radius in pixels of the area of the part that a branch needs to end on it.
constexpr int kFootPixels = 2;

/// Fills the pixels of the layers that share heights with [bottom, top].
template <typename Layer>
void FillBetween(const std::vector<Layer>& stack, Coord bottom_nm, Coord top_nm, Bitmap& bitmap) {
  auto layer = std::partition_point(stack.begin(), stack.end(),
                                    [&](const Layer& l) { return l.top_nm <= bottom_nm; });
  for (; layer != stack.end() && layer->bottom_nm() < top_nm; ++layer)
    bitmap.Fill(*layer->outlines);
}

/// Returns the largest squared distance of whole pixels up to `pixels`.
int32_t WholeStep(double pixels) {
  int32_t best = 0;
  const int most = static_cast<int>(pixels);
  for (int y = 0; y <= most; ++y)
    for (int x = y; x <= most; ++x)
      if (x * x + y * y <= pixels * pixels) best = std::max(best, x * x + y * y);
  return best;
}

/// Subtracts `by` distance steps from all distances.
void Subtract(std::vector<PixelDistance>& distances, int by) {
  const auto less = static_cast<PixelDistance>(std::clamp(by, 0, 255));
  for (PixelDistance& d : distances) d = static_cast<PixelDistance>(d > less ? d - less : 0);
}

std::vector<bool> Bits(const Bitmap& bitmap) {
  const uint8_t* bytes = bitmap.Row(0);
  return std::vector<bool>(bytes, bytes + bitmap.grid().size());
}

class FieldMaker {
 public:
  FieldMaker(const SupportProblem& problem, const SupportOptions& options, const PixelGrid& grid)
      : problem_(problem), options_(options), grid_(grid), off_bed_(grid) {
    if (problem.bed.empty()) return;
    Bitmap bed(grid);
    bed.Fill(problem.bed);
    for (int32_t y = 0; y < grid.height; ++y)
      for (int32_t x = 0; x < grid.width; ++x) off_bed_.Row(y)[x] = bed.At(x, y) ? 0 : 1;
  }

  std::vector<PixelDistance> Clear(const Slab& slab) const {
    Bitmap blocked = off_bed_;
    const Coord bottom = slab.bottom_nm - (slab.bottom_nm > 0 ? kOverlapNm : 0);
    const Coord top = slab.top_nm + std::max(options_.top_gap_nm, kOverlapNm);
    FillBetween(problem_.part, bottom, top, blocked);
    for (const auto& other : problem_.others) FillBetween(other, bottom, top, blocked);
    std::vector<PixelDistance> clear = DistanceTo(blocked);
    const Coord gap = XyGap(options_, slab.bottom_nm);
    Subtract(clear, static_cast<int>(gap * kDistanceSteps / grid_.pixel_nm));
    return clear;
  }

  /// Marks the pixels that the part, and other obstacles, occupy in a slab.
  void MarkSolid(const Slab& slab, std::vector<bool>& part, std::vector<bool>& other) const {
    Bitmap bitmap(grid_);
    FillBetween(problem_.part, slab.bottom_nm, slab.top_nm, bitmap);
    part = Bits(bitmap);
    bitmap = off_bed_;
    for (const auto& stack : problem_.others)
      FillBetween(stack, slab.bottom_nm, slab.top_nm, bitmap);
    other = Bits(bitmap);
  }

  /// Returns the pixels where the part below a slab is wide enough for a foot.
  std::vector<bool> Floor(const Slab& below, const Slab& slab) const {
    Bitmap solid(grid_);
    FillBetween(problem_.part, below.bottom_nm - kOverlapNm, slab.bottom_nm, solid);
    std::vector<PixelDistance> open(grid_.size());
    for (size_t i = 0; i < open.size(); ++i) open[i] = solid.Row(0)[i] ^ 1;
    open = MostWithin(open, grid_, kFootPixels * kFootPixels);
    std::vector<bool> floor(open.size());
    for (size_t i = 0; i < open.size(); ++i) floor[i] = open[i] == 0;
    return floor;
  }

 private:
  const SupportProblem& problem_;
  const SupportOptions& options_;
  const PixelGrid& grid_;
  Bitmap off_bed_;
};

/// Returns the grid over `box` with the smallest pixels for which the fields stay within the memory
/// limit.
PixelGrid GridFor(const SupportHeights& heights, const Box& box, const SupportOptions& options) {
  const int fields = options.bed_only ? 1 : 2;
  Coord pixel = ReachField::kPixelNm;
  for (;; pixel = pixel * 5 / 4) {
    const PixelGrid grid = GridOver(box, pixel);
    const auto slabs = SlabsOf(heights, options.tree.angle_rad, pixel).size();
    const double bytes = static_cast<double>(grid.size()) * static_cast<double>(slabs) * fields;
    if (bytes <= static_cast<double>(ReachField::kMaxFieldBytes)) return grid;
  }
}

}  // namespace

std::vector<Slab> SlabsOf(const SupportHeights& heights, double angle_rad, Coord pixel_nm) {
  const double slope = std::max(Tan(angle_rad), 0.01);
  const auto most = static_cast<Coord>(kPixelsInSlab * pixel_nm / slope);
  std::vector<Slab> slabs;
  double remainder = 0;
  for (size_t i = 0; i < heights.layers.size();) {
    Slab slab;
    slab.first_layer = slab.last_layer = static_cast<int32_t>(i);
    slab.bottom_nm = heights.layers[i].bottom_nm;
    slab.top_nm = heights.layers[i].top_nm;
    while (++i < heights.layers.size() && heights.layers[i].top_nm - slab.bottom_nm <= most) {
      slab.last_layer = static_cast<int32_t>(i);
      slab.top_nm = heights.layers[i].top_nm;
    }
    if (!slabs.empty()) {
      const double path =
          remainder +
          slope * static_cast<double>(slab.middle_nm() - slabs.back().middle_nm()) / pixel_nm;
      slabs.back().step_squared = WholeStep(path);
      remainder = std::min(1.0, path - std::sqrt(slabs.back().step_squared));
    }
    slabs.push_back(slab);
  }
  return slabs;
}

std::vector<PixelDistance> MostWithin(const std::vector<PixelDistance>& values,
                                      const PixelGrid& grid, int32_t step_squared) {
  std::vector<PixelDistance> most = values;
  const auto reach = static_cast<int32_t>(std::sqrt(step_squared));
  for (int32_t dy = -reach; dy <= reach; ++dy) {
    const auto across = static_cast<int32_t>(std::sqrt(step_squared - dy * dy));
    for (int32_t dx = -across; dx <= across; ++dx) {
      const int32_t x0 = std::max(0, -dx), x1 = std::min(grid.width, grid.width - dx);
      for (int32_t y = std::max(0, -dy); y < std::min(grid.height, grid.height - dy); ++y) {
        PixelDistance* out = most.data() + static_cast<size_t>(y) * grid.width;
        const PixelDistance* in = values.data() + static_cast<size_t>(y + dy) * grid.width + dx;
        int32_t x = x0;
        for (; x + 16 <= x1; x += 16)  // a fixed count, so that the compiler vectorises
          for (int k = 0; k < 16; ++k) out[x + k] = std::max(out[x + k], in[x + k]);
        for (; x < x1; ++x) out[x] = std::max(out[x], in[x]);
      }
    }
  }
  return most;
}

absl::StatusOr<ReachField> ReachField::Make(const SupportProblem& problem,
                                            const SupportHeights& heights, const Box& box,
                                            const SupportOptions& options, int threads,
                                            const CancelToken& cancel) {
  ReachField field;
  field.grid_ = GridFor(heights, box, options);
  field.slabs_ = SlabsOf(heights, options.tree.angle_rad, field.grid_.pixel_nm);
  const FieldMaker maker(problem, options, field.grid_);
  const size_t count = field.slabs_.size();
  const bool on_part = !options.bed_only;
  field.to_bed_.resize(count);
  field.part_.resize(count);
  field.other_.resize(count);
  std::vector<std::vector<bool>> floors(count);
  ForEachIndex(threads, count, [&](size_t s, int) {
    if (cancel.Cancelled()) return;
    field.to_bed_[s] = maker.Clear(field.slabs_[s]);
    maker.MarkSolid(field.slabs_[s], field.part_[s], field.other_[s]);
    if (on_part && s > 0) floors[s] = maker.Floor(field.slabs_[s - 1], field.slabs_[s]);
  });
  if (cancel.Cancelled()) return cancel.Check();
  if (on_part) field.to_part_ = field.to_bed_;
  ForEachIndex(threads, on_part ? 2 : 1, [&](size_t which, int) {
    std::vector<Plane>& planes = which == 0 ? field.to_bed_ : field.to_part_;
    for (size_t s = 1; s < count && !cancel.Cancelled(); ++s) {
      const Plane below = MostWithin(planes[s - 1], field.grid_, field.slabs_[s - 1].step_squared);
      for (size_t i = 0; i < below.size(); ++i)
        if (which == 0 || !floors[s][i]) planes[s][i] = std::min(planes[s][i], below[i]);
    }
  });
  if (cancel.Cancelled()) return cancel.Check();
  return field;
}

}  // namespace slicefarm::planning
