#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// Square block of side x side cells.
struct CellBlock {
  CurveCell first;  ///< lower left cell
  uint32_t side = 1;

  friend bool operator==(const CellBlock&, const CellBlock&) = default;
};

/// Window of a grid of square cells, with a flag for each cell that is inside a region.
struct CellCover {
  Point origin{};     ///< lower left corner of cell `first`
  Coord cell_nm = 1;  ///< side of a cell
  CurveCell first{};  ///< first cell of the window
  int32_t columns = 0;
  int32_t rows = 0;
  /// one flag per cell, row by row: not 0 if the cell is inside the region
  std::vector<char> inside{};

  /// Returns true if the cell is in the window and inside the region. `column` and `row` count from
  /// the window's first cell.
  bool Has(int32_t column, int32_t row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows &&
           inside[static_cast<size_t>(row) * columns + column] != 0;
  }
};

/// Returns the cells of a grid through the origin of coordinates that are completely in a region.
///
/// Indices of cells are counted from a corner of the grid far to the lower left. The corner is
/// chosen so that, for each k, the origin is well inside of a block of `base`^k x `base`^k cells.
/// So a small region near the origin is in a small block. REQUIRES: cell_nm > 0; `base` is 2 or 3;
/// the region is within 10^8 cells of the origin. Cost: O(n + cells), n points of the region.
CellCover CoverOf(const MultiPolygon& region, Coord cell_nm, uint32_t base);

/// Divides the cells inside the region into the largest blocks that a repeated division of the grid
/// by `base` per side gives: the leaves of a quadtree if `base` is 2. Blocks are sorted by size,
/// the smallest first, then row by row. Cost: O(cells).
std::vector<CellBlock> LargestBlocks(const CellCover& cover, uint32_t base);

/// Returns the boundary of all cells inside the region, as rings with these cells to their left:
/// outer rings are counter-clockwise. Where two cells touch only in a corner, the rings do not
/// cross. Cost: O(cells).
std::vector<Polygon> OutlineOf(const CellCover& cover);

}  // namespace slicefarm::infill
