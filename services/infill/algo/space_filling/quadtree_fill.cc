#include "services/infill/algo/space_filling/quadtree_fill.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/space_filling/cell_cover.h"
#include "services/infill/algo/space_filling/closed_curve.h"
#include "services/infill/algo/space_filling/depth_rings.h"
#include "services/infill/algo/space_filling/hilbert.h"
#include "services/infill/algo/space_filling/peano.h"

namespace slicefarm::infill {
namespace {

/// Space-filling curve that divides squares by `base` per side.
struct CellCurve {
  uint32_t base = 2;
  int index_order = 0;  ///< order of a square that contains all cells of a cover
  uint64_t (*index)(int order, CurveCell cell) = nullptr;
  std::vector<CurveCell> (*closed)(int order) = nullptr;
};

constexpr CellCurve kHilbert{2, 31, HilbertIndex, ClosedHilbert};
constexpr CellCurve kPeano{3, 18, PeanoIndex, ClosedPeano};

/// Returns the corners of a closed curve through cells, as positions in units of half a cell.
std::vector<CurveCell> CornersOf(const std::vector<CurveCell>& cells) {
  std::vector<CurveCell> corners;
  for (size_t i = 0; i < cells.size(); ++i) {
    const CurveCell before = cells[i == 0 ? cells.size() - 1 : i - 1], at = cells[i];
    const CurveCell after = cells[i + 1 == cells.size() ? 0 : i + 1];
    if (at.x - before.x == after.x - at.x && at.y - before.y == after.y - at.y) continue;
    corners.push_back(at);
  }
  return corners;
}

/// Returns the closed curves of a cover's blocks, in the order of the curve through all blocks. The
/// cover's cells are two spacings wide, the curve's cells one.
std::vector<StepRing> BlockRings(const CellCover& cover, const CellCurve& curve) {
  std::vector<CellBlock> blocks = LargestBlocks(cover, curve.base);
  const auto index = [&](const CellBlock& block) {
    // This is the least index in the block: the index of its first cell at the order of its side.
    int order = curve.index_order;
    for (uint32_t side = block.side; side > 1; side /= curve.base) --order;
    uint64_t first = curve.index(order, {block.first.x / block.side, block.first.y / block.side});
    return first * block.side * block.side;
  };
  std::vector<std::pair<uint64_t, size_t>> order;
  for (size_t i = 0; i < blocks.size(); ++i) order.emplace_back(index(blocks[i]), i);
  std::sort(order.begin(), order.end());
  std::map<uint32_t, std::vector<CurveCell>> corners_by_side;
  std::vector<StepRing> rings;
  const Coord spacing = cover.cell_nm / 2;
  for (const auto& [first, i] : order) {
    const CellBlock& block = blocks[i];
    std::vector<CurveCell>& corners = corners_by_side[block.side];
    if (corners.empty()) {
      int levels = 0;
      for (uint32_t side = block.side; side > 1; side /= curve.base) ++levels;
      corners = CornersOf(curve.closed(levels));
    }
    const Point base = {
        cover.origin.x + static_cast<Coord>(block.first.x - cover.first.x) * cover.cell_nm,
        cover.origin.y + static_cast<Coord>(block.first.y - cover.first.y) * cover.cell_nm};
    StepRing& ring = rings.emplace_back();
    for (const CurveCell corner : corners) {
      ring.points.push_back({base.x + static_cast<Coord>(corner.x) * spacing + spacing / 2,
                             base.y + static_cast<Coord>(corner.y) * spacing + spacing / 2});
    }
  }
  return rings;
}

/// Fills a part of a region that is already inset by half a spacing: it contains the lines'
/// centres, not their width.
std::vector<Polyline> FillPart(const PolygonWithHoles& part, Coord spacing,
                               const CellCurve& curve) {
  // The inset leaves space for a line along the part's boundary, and for a line around the cells.
  const CellCover cover =
      CoverOf(FastOffset({part}, -(spacing + spacing / 2)), 2 * spacing, curve.base);
  const MultiPolygon cells = Union(OutlineOf(cover), FillRule::kNonZero);
  std::vector<StepRing> band =
      RingsFrom(Difference({part}, FastOffset(cells, spacing / 2)), spacing);
  // Curves in cells are first, because they can be linked only at some points. Lines along the
  // cells can be linked anywhere.
  std::vector<StepRing> rings = BlockRings(cover, curve);
  int32_t step = band.empty() ? 0 : band.back().step;
  for (StepRing& ring : rings) ring.step = ++step;
  std::move(band.begin(), band.end(), std::back_inserter(rings));
  return LinkRings(rings, static_cast<double>(spacing));
}

absl::StatusOr<std::vector<Polyline>> Fill(const PolygonWithHoles& region,
                                           const QuadtreeOptions& options, const CellCurve& curve) {
  const Coord spacing = options.spacing_nm;
  if (absl::Status status = CheckRingSpacing(region, spacing); !status.ok()) return status;
  std::vector<Polyline> paths;
  for (const PolygonWithHoles& part :
       FastOffset({region}, -FirstLineDepth(options.first_line, spacing))) {
    std::vector<Polyline> linked = FillPart(part, spacing, curve);
    std::move(linked.begin(), linked.end(), std::back_inserter(paths));
  }
  return paths;
}

}  // namespace

absl::StatusOr<std::vector<Polyline>> HilbertFill(const PolygonWithHoles& region,
                                                  const QuadtreeOptions& options) {
  return Fill(region, options, kHilbert);
}

absl::StatusOr<std::vector<Polyline>> PeanoFill(const PolygonWithHoles& region,
                                                const QuadtreeOptions& options) {
  return Fill(region, options, kPeano);
}

}  // namespace slicefarm::infill
