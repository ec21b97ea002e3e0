#include "services/planning/algo/supports/generator/kept_rings.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/supports/generator/part_below.h"
#include "services/planning/algo/supports/generator/raster.h"
#include "services/planning/algo/supports/generator/reach_field.h"
#include "services/planning/algo/supports/generator/tolerances.h"

namespace slicefarm::planning {
namespace {

constexpr Coord kRingPixelNm = 200'000;
constexpr double kMostRingPixels = 2'000'000;
/// Distance up to which a loop beside the pixels below it counts as supported by them.
constexpr Coord kNearNm = 800'000;
/// Step along a loop between tested points.
constexpr Coord kStepNm = 300'000;
/// Smallest area of a hole with a loop around it.
constexpr double kLeastHoleNm2 = 0.05e12;

int Loops(SupportRole role) { return role == SupportRole::kThickBranch ? 2 : 1; }

bool IsHollow(const SupportLayer& layer, const SupportRegion& region) {
  return !layer.first &&
         (region.role == SupportRole::kBranch || region.role == SupportRole::kThickBranch);
}

/// Pixels near the support of a layer.
struct SupportedPixels {
  PixelGrid grid;
  std::vector<PixelDistance> near;

  bool At(Point p) const {
    return near[static_cast<size_t>(grid.Row(p.y)) * grid.width + grid.Column(p.x)] != 0;
  }
};

/// Returns true if every unsupported section of the ring is short enough to be a bridge.
bool LiesOn(const Polygon& ring, const SupportedPixels& supported) {
  constexpr double kMost = kBridgedNm - 2 * kNearNm;
  double first = -1, run = 0, longest = 0;  // `first`: length of the run at the start of the ring
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], by = ring[i + 1 < ring.size() ? i + 1 : 0] - a;
    const double length = Distance(a, a + by);
    const auto steps = static_cast<Coord>(length / kStepNm) + 1;
    for (Coord k = 0; k < steps; ++k) {
      if (!supported.At({a.x + by.x * k / steps, a.y + by.y * k / steps})) {
        run += length / static_cast<double>(steps);
        longest = std::max(longest, run);
        continue;
      }
      if (first < 0) first = run;
      run = 0;
    }
  }
  return first >= 0 && std::max(longest, first + run) <= kMost;
}

/// Returns the ring shrunk by `by_nm`, or by less if the result would be empty.
MultiPolygon Inside(const Polygon& ring, Coord by_nm) {
  MultiPolygon inside;
  for (Coord by = by_nm; by >= by_nm / 4 && Area(inside) < kLeastHoleNm2; by /= 2)
    inside = FastOffset({{ring, {}}}, -by);
  return inside;
}

class Keeper {
 public:
  Keeper(const SupportProblem& problem, const SupportOptions& options,
         std::vector<SupportLayer>& layers)
      : problem_(problem), options_(options), layers_(layers), doubtful_(layers.size(), 0) {}

  /// Marks the layer if some of its loops have no support from the layer below in its current
  /// state.
  void Look(size_t index) { doubtful_[index] = !Unsupported(index, true).empty(); }

  /// Cuts holes into the layer below for unsupported loops. REQUIRES: called from the top down.
  void Keep(size_t index) {
    if (!doubtful_[index] || index == 0) return;
    const MultiPolygon holes = Unsupported(index, false);
    SupportLayer& below = layers_[index - 1];
    bool changed = false;
    for (SupportRegion& region : below.regions)
      if (IsHollow(below, region)) changed |= Cut(holes, region);
    if (changed) doubtful_[index - 1] = 1;
  }

 private:
  /// Returns the areas inside unsupported loops; with `one`, only the first of them.
  MultiPolygon Unsupported(size_t index, bool one) const {
    const SupportLayer& layer = layers_[index];
    Box box;
    for (const SupportRegion& region : layer.regions)
      if (IsHollow(layer, region)) box.Add(Bounds(region.outlines));
    if (box.Empty()) return {};
    const SupportedPixels supported = SupportedOn(index, box.Grown(2 * kNearNm));
    std::vector<Polygon> areas;
    for (const SupportRegion& region : layer.regions) {
      if (!IsHollow(layer, region)) continue;
      const Coord wall = Loops(region.role) * options_.width_nm;
      for (const PolygonWithHoles& island : region.outlines) {
        if (one && !areas.empty()) return {{std::move(areas.front()), {}}};
        if (!LiesOn(island.outer, supported))
          for (PolygonWithHoles& inside : Inside(island.outer, wall))
            areas.push_back(std::move(inside.outer));
        for (const Polygon& hole : island.holes)
          if (!LiesOn(hole, supported)) areas.push_back({hole.rbegin(), hole.rend()});
      }
    }
    return Union(areas, FillRule::kNonZero);
  }

  SupportedPixels SupportedOn(size_t index, const Box& box) const {
    const Coord bottom = layers_[index].top_nm - layers_[index].height_nm;
    Coord pixel = kRingPixelNm;
    while (static_cast<double>(GridOver(box, pixel).size()) > kMostRingPixels) pixel *= 2;
    Bitmap bitmap(GridOver(box, pixel));
    if (index > 0 && layers_[index - 1].top_nm >= bottom - support::kSameHeightNm)
      for (const SupportRegion& region : layers_[index - 1].regions) {
        if (!IsHollow(layers_[index - 1], region)) bitmap.Fill(region.outlines);
        bitmap.FillEdges(region.outlines);
      }
    ForEachPartBelow(problem_, options_, bottom,
                     [&](const MultiPolygon& outlines) { bitmap.Fill(outlines); });
    const std::vector<PixelDistance> set(bitmap.Row(0), bitmap.Row(0) + bitmap.grid().size());
    const auto reach = static_cast<int32_t>(kNearNm / pixel);
    return {bitmap.grid(), MostWithin(set, bitmap.grid(), reach * reach)};
  }

  /// Cuts the holes into a region, as far as there is space beside the existing loops. Returns true
  /// if the region changes.
  bool Cut(const MultiPolygon& holes, SupportRegion& region) const {
    bool changed = false;
    MultiPolygon outlines;
    for (PolygonWithHoles& island : region.outlines) {
      MultiPolygon room;
      if (!Intersection({island}, holes).empty())
        room =
            Intersection(holes, FastOffset({island}, -2 * Loops(region.role) * options_.width_nm));
      std::erase_if(room, [](const PolygonWithHoles& r) { return Area(r) < kLeastHoleNm2; });
      changed |= !room.empty();
      if (room.empty())
        outlines.push_back(std::move(island));
      else
        for (PolygonWithHoles& rest : Difference({island}, room))
          outlines.push_back(std::move(rest));
    }
    Canonicalize(outlines);
    region.outlines = std::move(outlines);
    return changed;
  }

  const SupportProblem& problem_;
  const SupportOptions& options_;
  std::vector<SupportLayer>& layers_;
  std::vector<uint8_t> doubtful_;
};

}  // namespace

void KeepRings(const SupportProblem& problem, const SupportOptions& options, int threads,
               const CancelToken& cancel, std::vector<SupportLayer>& layers) {
  Keeper keeper(problem, options, layers);
  ForEachIndex(threads, layers.size(), [&](size_t i, int) {
    if (!cancel.Cancelled()) keeper.Look(i);
  });
  for (size_t i = layers.size(); i-- > 0 && !cancel.Cancelled();) keeper.Keep(i);
}

}  // namespace slicefarm::planning
