#include "services/infill/algo/fields/field_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/fields/cell_limit.h"
#include "services/infill/algo/space_filling/cell_cover.h"

namespace slicefarm::infill {
namespace {

/// Returns the window of cells that meet the region's box, without values.
FieldCells WindowOf(const MultiPolygon& region, Coord cell_nm) {
  const Box box = Bounds(region);
  const auto index = [&](Coord at) {
    return static_cast<int64_t>(std::floor(static_cast<double>(at) / static_cast<double>(cell_nm)));
  };
  const int64_t x = index(box.min.x), y = index(box.min.y);
  return {x, y, index(box.max.x - 1) - x + 1, index(box.max.y - 1) - y + 1, cell_nm, {}, {}};
}

std::vector<char> Touched(const MultiPolygon& region, const FieldCells& cells) {
  std::vector<char> touched(static_cast<size_t>(cells.width * cells.height), 0);
  const Coord cell_nm = cells.cell_nm;
  for (int64_t y = 0; y < cells.height; ++y) {
    const Coord low = (cells.first_y + y) * cell_nm;
    const Coord left = cells.first_x * cell_nm, right = left + cells.width * cell_nm;
    const MultiPolygon row = Intersection(
        region, {{{{left, low}, {right, low}, {right, low + cell_nm}, {left, low + cell_nm}}, {}}});
    for (const PolygonWithHoles& island : row) {
      const Box box = Bounds(island.outer);
      const int64_t first = (box.min.x - left) / cell_nm;
      const int64_t last = std::min((box.max.x - 1 - left) / cell_nm, cells.width - 1);
      for (int64_t x = first; x <= last; ++x) touched[static_cast<size_t>(y * cells.width + x)] = 1;
    }
  }
  return touched;
}

}  // namespace

absl::StatusOr<FieldCells> FieldCellsOf(const MultiPolygon& region, const LayerField& field,
                                        double cell_mm) {
  if (region.empty()) return FieldCells{};
  FieldCells cells = WindowOf(region, FromMm(cell_mm));
  const double count = static_cast<double>(cells.width) * static_cast<double>(cells.height);
  if (absl::Status ok = CheckFieldSize(kMaxFieldCells, count); !ok.ok()) return ok;
  cells.touched = Touched(region, cells);
  const auto middle = [&](int64_t index) { return (static_cast<double>(index) + 0.5) * cell_mm; };
  for (int64_t y = 0; y < cells.height; ++y)
    for (int64_t x = 0; x < cells.width; ++x)
      cells.density.push_back(
          field.DensityAt(middle(cells.first_x + x), middle(cells.first_y + y)));
  return cells;
}

MultiPolygon PartInCells(const MultiPolygon& region, const FieldCells& cells,
                         std::vector<char> on) {
  const CellCover cover{.origin = {cells.first_x * cells.cell_nm, cells.first_y * cells.cell_nm},
                        .cell_nm = cells.cell_nm,
                        .columns = static_cast<int32_t>(cells.width),
                        .rows = static_cast<int32_t>(cells.height),
                        .inside = std::move(on)};
  return Intersection(region, Union(OutlineOf(cover), FillRule::kNonZero));
}

}  // namespace slicefarm::infill
