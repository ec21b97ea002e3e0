#include "services/planning/algo/supports/generator/interfaces.h"

#include <algorithm>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/tolerances.h"
#include "services/planning/algo/supports/generator/widened.h"

namespace slicefarm::planning {
namespace {

/// Height of a plinth. Below this height branches have spread by less than the distance between
/// them.
constexpr Coord kPlinthNm = 2'000'000;
/// Smallest area of a region, in nm^2. A smaller dot would stick to the nozzle and come off.
constexpr double kLeastBeadNm2 = 0.08e12;

MultiPolygon UnionOf(const std::vector<MultiPolygon>& regions, size_t from, size_t to) {
  std::vector<Polygon> rings;
  size_t filled = 0, last = 0;
  for (size_t i = from; i < to; ++i) {
    if (regions[i].empty()) continue;
    ++filled;
    last = i;
    for (Polygon& ring : Rings(regions[i])) rings.push_back(std::move(ring));
  }
  if (filled <= 1) return filled == 0 ? MultiPolygon() : regions[last];
  return Union(rings, FillRule::kNonZero);
}

void Add(SupportRole role, MultiPolygon outlines, SupportLayer& layer) {
  std::erase_if(outlines, [](const PolygonWithHoles& i) { return Area(i) < kLeastBeadNm2; });
  if (!outlines.empty()) layer.regions.push_back({role, std::move(outlines)});
}

SupportLayer LayerAt(const SupportHeights& heights, size_t i) {
  const SupportHeight& h = heights.layers[i];
  return {h.top_nm, h.top_nm - h.bottom_nm, i == 0, {}};
}

std::vector<SupportLayer> NotEmpty(std::vector<SupportLayer> layers) {
  std::erase_if(layers, [](const SupportLayer& layer) { return layer.regions.empty(); });
  return layers;
}

/// Returns the region without parts narrower than `narrow_nm`. Columns have narrow teeth where
/// pixels meet the part, and narrow slits between blocked areas. Beads there would be loose crumbs.
MultiPolygon WithoutTeeth(const MultiPolygon& region, Coord narrow_nm) {
  const MultiPolygon core = FastOffset(region, -narrow_nm / 2);
  return core.empty() ? core : Intersection(region, FastOffset(core, narrow_nm * 9 / 16));
}

/// Smallest widths of a base and of a sheet, where the part is near on both sides.
constexpr Coord LeastBase(Coord width_nm) { return width_nm * 2 / 3; }
constexpr Coord LeastSheet(Coord width_nm) { return width_nm * 2 / 5; }

/// Returns the islands of a sheet that are smaller than a cell of the base's lines, grown by half
/// of `spacing_nm`. Without this, the first layer of such a small sheet could be between two lines
/// and be printed into the air.
MultiPolygon OverALine(const MultiPolygon& sheet, Coord spacing_nm) {
  MultiPolygon small;
  for (const PolygonWithHoles& island : sheet) {
    const Box box = Bounds(island.outer);
    if (std::max(box.max.x - box.min.x, box.max.y - box.min.y) < spacing_nm)
      small.push_back(island);
  }
  return small.empty() ? small : FastOffset(small, spacing_nm / 2);
}

/// Moves islands of the base to `top` if the base's lines may miss them: islands that meet
/// `contacts` and are narrower than the distance of the lines. A full column always contains a
/// line. An island with only a contact's outline may contain none, and the interface on it would be
/// printed into the air.
void TakeNarrow(const MultiPolygon& contacts, Coord spacing_nm, MultiPolygon& base,
                MultiPolygon& top) {
  MultiPolygon narrow;
  std::erase_if(base, [&](const PolygonWithHoles& island) {
    const Box box = Bounds(island.outer);
    const Coord width_nm = std::min(box.max.x - box.min.x, box.max.y - box.min.y);
    if (width_nm >= spacing_nm || Intersection({island}, contacts).empty()) return false;
    narrow.push_back(island);
    return true;
  });
  if (!narrow.empty()) top = top.empty() ? narrow : Union(top, narrow);
}

/// Returns the areas of `bodies` that are on outlines of the part. Bodies are processed one by one:
/// few have the part below them, and only a small piece of the part is near each.
MultiPolygon LyingOn(const std::vector<const MultiPolygon*>& part, const MultiPolygon& bodies) {
  MultiPolygon lying;
  for (const PolygonWithHoles& body : bodies) {
    std::vector<Polygon> rings;
    const Box box = Bounds(body.outer);
    for (const MultiPolygon* outlines : part) AppendRingsNear(*outlines, box, rings);
    if (rings.empty()) continue;
    for (PolygonWithHoles& on : Difference({body}, WithoutRings({body}, rings)))
      lying.push_back(std::move(on));
  }
  return lying;
}

bool Supports(const PolygonWithHoles& column, const MultiPolygon& above) {
  return !above.empty() && Area(Intersection({column}, above)) >= support::kLeastRegionNm2;
}

/// Removes islands of the base that are left beside sheets and support no column above the sheets.
void DropSpent(const MultiPolygon& columns_above, MultiPolygon& base) {
  std::erase_if(base,
                [&](const PolygonWithHoles& island) { return !Supports(island, columns_above); });
}

/// Returns the end of the range of layers with contacts that belong to the sheet of `layer`: this
/// layer and the top_interface_layers - 1 layers above.
size_t EndOfSheet(size_t layer, size_t count, const SupportOptions& options) {
  return std::min(count, layer + static_cast<size_t>(std::max(1, options.top_interface_layers)));
}

}  // namespace

std::vector<MultiPolygon> Sheets(const SupportHeights& heights, const Contacts& contacts,
                                 const Clearance& clearance, const SupportOptions& options,
                                 int threads, const CancelToken& cancel) {
  const size_t count = heights.layers.size();
  std::vector<MultiPolygon> sheets(count);
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    MultiPolygon all = contacts[i];
    const MultiPolygon higher = UnionOf(contacts, i + 1, EndOfSheet(i, count, options));
    // Contacts of higher layers are grown slightly, so that no step is separated from the next.
    if (!higher.empty()) all = Union(all, FastOffset(higher, 2 * kEdgeNm));
    const SupportHeight& height = heights.layers[i];
    sheets[i] = clearance.Free(all, height.bottom_nm, height.top_nm);
    const MultiPolygon wide = Widened(sheets[i], options.width_nm * 4 / 5);
    if (!wide.empty())
      sheets[i] = Union(sheets[i], clearance.Free(wide, height.bottom_nm, height.top_nm));
    sheets[i] = WithoutTeeth(sheets[i], LeastSheet(options.width_nm));
    std::erase_if(sheets[i],
                  [](const PolygonWithHoles& s) { return Area(s) < support::kLeastRegionNm2; });
  });
  return sheets;
}

std::vector<MultiPolygon> Plinths(const SupportHeights& heights, const Contacts& contacts,
                                  const Clearance& clearance, int threads,
                                  const CancelToken& cancel) {
  std::vector<MultiPolygon> plinths(heights.layers.size());
  const auto end = static_cast<size_t>(
      std::ranges::upper_bound(heights.layers, kPlinthNm, {}, &SupportHeight::top_nm) -
      heights.layers.begin());
  ForEachIndex(threads, end, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    const MultiPolygon higher = UnionOf(contacts, i, end);
    const SupportHeight& height = heights.layers[i];
    if (!higher.empty()) plinths[i] = clearance.Free(higher, height.bottom_nm, height.top_nm);
  });
  return plinths;
}

std::vector<MultiPolygon> Floors(const SupportProblem& problem, const SupportHeights& heights,
                                 const std::vector<MultiPolygon>& bodies,
                                 const SupportOptions& options, int threads,
                                 const CancelToken& cancel) {
  const size_t count = heights.layers.size();
  std::vector<MultiPolygon> lying(count), floors(count);
  if (options.bottom_interface_layers <= 0 || options.bed_only) return floors;
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    if (bodies[i].empty()) return;
    const Coord highest =
        heights.layers[i].bottom_nm - options.bottom_gap_nm + support::kSameHeightNm;
    const Coord lowest = highest - options.layer_height_nm;
    std::vector<const MultiPolygon*> part;
    for (const PartLayer& layer : problem.part)
      if (layer.top_nm > lowest && layer.top_nm <= highest) part.push_back(layer.outlines);
    if (!part.empty()) lying[i] = LyingOn(part, bodies[i]);
  });
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    const auto below = static_cast<size_t>(options.bottom_interface_layers);
    const MultiPolygon all = UnionOf(lying, i + 1 > below ? i + 1 - below : 0, i + 1);
    if (!all.empty()) floors[i] = Intersection(bodies[i], all);
  });
  return floors;
}

void DropUseless(const Contacts& contacts, Coord narrow_nm, std::vector<MultiPolygon>& columns) {
  for (size_t i = columns.size(); i-- > 0;) {
    std::erase_if(columns[i], [&](const PolygonWithHoles& column) {
      const Box box = Bounds(column.outer);
      const Coord width_nm = std::min(box.max.x - box.min.x, box.max.y - box.min.y);
      return width_nm < narrow_nm && !Supports(column, contacts[i]) &&
             !(i + 1 < columns.size() && Supports(column, columns[i + 1]));
    });
  }
}

std::vector<SupportLayer> ColumnLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<MultiPolygon>& columns,
                                       const Contacts& contacts, const SupportOptions& options,
                                       int threads, const CancelToken& cancel) {
  const size_t count = heights.layers.size();
  const auto floors = Floors(problem, heights, columns, options, threads, cancel);
  std::vector<SupportLayer> layers(count);
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    layers[i] = LayerAt(heights, i);
    const size_t end = EndOfSheet(i, count, options);
    MultiPolygon top;
    if (options.top_interface_layers > 0) {
      top = UnionOf(contacts, i, end);
      if (!top.empty()) top = FastOffset(top, options.width_nm / 2);
      if (end > i + 1)
        top = Union(top, OverALine(contacts[end - 1], options.spacing_nm + options.width_nm));
      if (!top.empty())
        top = WithoutTeeth(Intersection(top, columns[i]), LeastSheet(options.width_nm));
    }
    MultiPolygon base = top.empty() ? columns[i] : Difference(columns[i], top);
    if (options.top_interface_layers > 0)
      DropSpent(end < count ? columns[end] : MultiPolygon(), base);
    const MultiPolygon bottom = Intersection(floors[i], base);
    if (!bottom.empty()) base = Difference(base, bottom);
    base = WithoutTeeth(base, LeastBase(options.width_nm));
    const MultiPolygon under = UnionOf(contacts, i, std::min(count, i + support::kExactLayers));
    if (!under.empty()) TakeNarrow(under, options.spacing_nm + options.width_nm, base, top);
    Add(SupportRole::kBase, std::move(base), layers[i]);
    Add(SupportRole::kTopInterface, std::move(top), layers[i]);
    Add(SupportRole::kBottomInterface, bottom, layers[i]);
  });
  return NotEmpty(std::move(layers));
}

std::vector<SupportLayer> BranchLayers(const SupportProblem& problem, const SupportHeights& heights,
                                       const std::vector<BranchSections>& branches,
                                       const std::vector<MultiPolygon>& sheets,
                                       const std::vector<MultiPolygon>& plinths,
                                       const SupportOptions& options, int threads,
                                       const CancelToken& cancel) {
  const size_t count = heights.layers.size();
  std::vector<MultiPolygon> bodies(count);
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    bodies[i] = branches[i].thin;
    bodies[i].insert(bodies[i].end(), branches[i].thick.begin(), branches[i].thick.end());
  });
  const auto floors = Floors(problem, heights, bodies, options, threads, cancel);
  std::vector<SupportLayer> layers(count);
  ForEachIndex(threads, count, [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    layers[i] = LayerAt(heights, i);
    MultiPolygon taken = sheets[i];
    if (!plinths[i].empty()) {
      Add(SupportRole::kBase, taken.empty() ? plinths[i] : Difference(plinths[i], taken),
          layers[i]);
      taken = Union(taken, plinths[i]);
    }
    const auto add = [&](SupportRole role, const MultiPolygon& branch) {
      MultiPolygon rest = taken.empty() ? branch : Difference(branch, taken);
      if (floors[i].empty()) return Add(role, std::move(rest), layers[i]);
      const MultiPolygon bottom = Intersection(rest, floors[i]);
      Add(role, Difference(rest, bottom), layers[i]);
      Add(SupportRole::kBottomInterface, bottom, layers[i]);
    };
    add(SupportRole::kBranch, branches[i].thin);
    add(SupportRole::kThickBranch, branches[i].thick);
    Add(options.top_interface_layers > 0 ? SupportRole::kTopInterface : SupportRole::kBase,
        sheets[i], layers[i]);
    std::stable_sort(layers[i].regions.begin(), layers[i].regions.end(),
                     [](const auto& a, const auto& b) { return a.role < b.role; });
  });
  return NotEmpty(std::move(layers));
}

}  // namespace slicefarm::planning
