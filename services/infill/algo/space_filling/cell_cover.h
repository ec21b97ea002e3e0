#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// A square of side x side cells.
struct CellBlock {
  CurveCell first;  ///< lower left
  uint32_t side = 1;

  friend bool operator==(const CellBlock&, const CellBlock&) = default;
};

/// A window of a grid of square cells, and which of them are inside something.
struct CellCover {
  Point origin{};     ///< lower left corner of cell `first`
  Coord cell_nm = 1;  ///< side of a cell
  CurveCell first{};  ///< of the window
  int32_t columns = 0;
  int32_t rows = 0;
  std::vector<char> inside{};  ///< row by row

  bool Has(int32_t column, int32_t row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows &&
           inside[static_cast<size_t>(row) * columns + column] != 0;
  }
};

/// The cells that lie in a region as a whole, of a grid through the origin of coordinates.
///
/// Cells are counted from a corner so far to the lower left that the origin lies well inside of a
/// square of `base`^k cells for each k, `base` 2 or 3: a small region there is in a small square.
/// REQUIRES: cell_nm > 0; the region lies within 10^8 cells of the origin. Cost: O(n + cells).
CellCover CoverOf(const MultiPolygon& region, Coord cell_nm, uint32_t base);

/// Divides the cells into the largest squares that a division of the grid by `base` a side, again
/// and again, gives: a quadtree's leaves if `base` is 2. By size, the smallest first, then row by
/// row. Cost: O(cells).
std::vector<CellBlock> LargestBlocks(const CellCover& cover, uint32_t base);

/// The edge of all cells as rings, the cells to their left: outer rings turn counter-clockwise.
/// Where two cells touch in a corner only, the rings do not cross. Cost: O(cells).
std::vector<Polygon> OutlineOf(const CellCover& cover);

}  // namespace slicefarm::infill
