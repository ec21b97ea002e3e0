#include "services/planning/algo/supports/generator/standing.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/supports/generator/part_below.h"
#include "services/planning/algo/supports/generator/raster.h"
#include "services/planning/algo/supports/generator/reach_field.h"
#include "services/planning/algo/supports/generator/tolerances.h"

namespace slicefarm::planning {
namespace {

constexpr Coord kPixelNm = 250'000;
/// Radius of a disc that limits sheets on tips. The boundary of a sheet is the envelope of this
/// disc when it is rolled along the outside of the tips, moved outwards by kReachNm. So sheets span
/// between two tips and extend beyond the outer tips by kReachNm.
constexpr Coord kHalfSpanNm = 1'600'000;
/// Change of an area, in nm^2, that rounding in boolean operations may cause.
constexpr double kUnchangedNm2 = 1e9;
constexpr double kMostPixels = 2'000'000;

Box BoundsOf(const SupportLayer& layer) {
  Box box;
  for (const SupportRegion& region : layer.regions) box.Add(Bounds(region.outlines));
  return box;
}

class Standing {
 public:
  Standing(const SupportProblem& problem, const SupportOptions& options,
           std::vector<SupportLayer>& layers)
      : problem_(problem), options_(options), layers_(layers), doubtful_(layers.size(), 0) {}

  /// Marks the layer as doubtful unless the layer below, in its current state, clearly supports
  /// each of its islands.
  void Look(size_t index) {
    const SupportLayer& layer = layers_[index];
    if (layer.first) return;
    const Box box = BoundsOf(layer).Grown(2 * kReachNm);
    Coord pixel = kPixelNm;
    while (static_cast<double>(GridOver(box, pixel).size()) > kMostPixels) pixel *= 2;
    Bitmap rest(GridOver(box, pixel));
    ForEachSupporter(index, [&](const MultiPolygon& outlines) { rest.Fill(outlines); });
    const std::vector<PixelDistance> near = Near(rest);
    for (const SupportRegion& region : layer.regions)
      for (const PolygonWithHoles& island : region.outlines)
        if (!SeenToStand(island, rest, near)) doubtful_[index] = 1;
  }

  /// Removes unsupported areas. REQUIRES: called from the bed up.
  void Cut(size_t index) {
    if (!doubtful_[index]) return;
    SupportLayer& layer = layers_[index];
    const Box box = BoundsOf(layer).Grown(2 * kReachNm);
    std::vector<Polygon> rings;
    ForEachSupporter(index,
                     [&](const MultiPolygon& outlines) { AppendRingsNear(outlines, box, rings); });
    const MultiPolygon rest = Union(rings, FillRule::kNonZero);
    const MultiPolygon around =
        Spans() ? FastOffset(FastOffset(rest, kHalfSpanNm), kReachNm - kHalfSpanNm)
                : FastOffset(rest, kReachNm);
    const MultiPolygon all = Whole(layer);
    MultiPolygon kept;
    for (PolygonWithHoles& island : Intersection(all, around))
      if (!Intersection({island}, rest).empty()) kept.push_back(std::move(island));
    if (Area(all) - Area(kept) < kUnchangedNm2) return;
    for (SupportRegion& region : layer.regions)
      region.outlines = Intersection(region.outlines, kept);
    std::erase_if(layer.regions, [](const SupportRegion& r) { return r.outlines.empty(); });
    if (index + 1 < layers_.size()) doubtful_[index + 1] = 1;
  }

 private:
  /// Calls visit(outlines) with all outlines that may support the layer: support and part below it.
  template <typename Visit>
  void ForEachSupporter(size_t index, Visit visit) const {
    const Coord bottom = layers_[index].top_nm - layers_[index].height_nm;
    if (index > 0 && layers_[index - 1].top_nm >= bottom - support::kSameHeightNm)
      for (const SupportRegion& region : layers_[index - 1].regions) visit(region.outlines);
    ForEachPartBelow(problem_, options_, bottom, visit);
  }

  /// Returns true if sheets span from tip to tip.
  bool Spans() const { return options_.style == SupportStyle::kTree; }

  /// Returns a map that is not 0 for pixels within kReachNm of `rest`, the support below the layer.
  std::vector<PixelDistance> Near(const Bitmap& rest) const {
    const PixelGrid& grid = rest.grid();
    const auto reach = static_cast<int32_t>(kReachNm / grid.pixel_nm);
    std::vector<PixelDistance> near(rest.Row(0), rest.Row(0) + grid.size());
    if (!Spans()) return MostWithin(near, grid, reach * reach);
    const auto steps = [&](Coord length) {
      return static_cast<PixelDistance>(length * kDistanceSteps / grid.pixel_nm);
    };
    const std::vector<PixelDistance> distance = DistanceTo(rest);
    Bitmap beyond(grid);
    for (size_t i = 0; i < near.size(); ++i)
      beyond.Row(0)[i] = distance[i] > steps(kHalfSpanNm) ? 1 : 0;
    const std::vector<PixelDistance> inside = DistanceTo(beyond);
    for (size_t i = 0; i < near.size(); ++i)
      near[i] = inside[i] > steps(kHalfSpanNm - kReachNm) ? 1 : 0;
    return near;
  }

  static bool SeenToStand(const PolygonWithHoles& island, const Bitmap& rest,
                          const std::vector<PixelDistance>& near) {
    const PixelGrid& grid = rest.grid();
    bool touches = false;
    for (const Point p : island.outer) {
      const int32_t x = grid.Column(p.x), y = grid.Row(p.y);
      if (!near[static_cast<size_t>(y) * grid.width + x]) return false;
      touches |= rest.At(x, y);
    }
    return touches;
  }

  /// Returns all regions of a layer, joined where they touch.
  static MultiPolygon Whole(const SupportLayer& layer) {
    MultiPolygon all;
    for (const SupportRegion& region : layer.regions) {
      // Regions are grown slightly, so that neighbouring regions merge.
      const MultiPolygon wide = FastOffset(region.outlines, 2'000);
      all = Union(all, wide);
    }
    return all;
  }

  const SupportProblem& problem_;
  const SupportOptions& options_;
  std::vector<SupportLayer>& layers_;
  std::vector<uint8_t> doubtful_;
};

}  // namespace

void KeepStanding(const SupportProblem& problem, const SupportOptions& options, int threads,
                  const CancelToken& cancel, std::vector<SupportLayer>& layers) {
  Standing standing(problem, options, layers);
  ForEachIndex(threads, layers.size(), [&](size_t i, int) {
    if (!cancel.Cancelled()) standing.Look(i);
  });
  for (size_t i = 0; i < layers.size() && !cancel.Cancelled(); ++i) standing.Cut(i);
  std::erase_if(layers, [](const SupportLayer& layer) { return layer.regions.empty(); });
}

}  // namespace slicefarm::planning
