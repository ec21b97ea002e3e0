#include "services/slicing/algo/placement/arranging/grid_positions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "common/geometry/measure.h"
#include "services/slicing/algo/placement/arranging/free_positions.h"

namespace slicefarm::slicing {
namespace {

constexpr Coord kMostInARow = 1'000;

Coord RoundedUp(Coord value) { return (value + kPositionStep - 1) / kPositionStep * kPositionStep; }
Coord Rounded(Coord value) { return std::llround(1.0 * value / kPositionStep) * kPositionStep; }

struct Grid {
  Point middle;  ///< translation that moves one part to the middle of the bed
  Coord dx = 0, dy = 0;
  Coord columns = 0, rows = 0;  ///< size of the largest grid in the bed's box

  /// Returns the offset of position i of a row with `of` positions. The row is centred: if `of` is
  /// even, the positions nearest to the middle are half a pitch away from it.
  static Coord Offset(Coord pitch, Coord i, Coord of) {
    return i * pitch - Rounded((of - 1) * pitch / 2);
  }
  Point At(Coord column, Coord of_columns, Coord row, Coord of_rows) const {
    return middle + Point{Offset(dx, column, of_columns), Offset(dy, row, of_rows)};
  }
};

Grid GridOn(const Polygon& bed, const Box& part, Coord distance_nm) {
  const Box box = Bounds(bed);
  const auto middle = [](Coord min, Coord max) { return min + (max - min) / 2; };
  const auto fitting = [](Coord space, Coord size, Coord pitch) {
    return space < size ? 0 : std::min(kMostInARow, 1 + (space - size) / pitch);
  };
  const Point size = part.max - part.min, space = box.max - box.min;
  Grid grid;
  grid.middle = {Rounded(middle(box.min.x, box.max.x) - middle(part.min.x, part.max.x)),
                 Rounded(middle(box.min.y, box.max.y) - middle(part.min.y, part.max.y))};
  grid.dx = std::max(kPositionStep, RoundedUp(size.x + distance_nm));
  grid.dy = std::max(kPositionStep, RoundedUp(size.y + distance_nm));
  grid.columns = fitting(space.x, size.x, grid.dx);
  grid.rows = fitting(space.y, size.y, grid.dy);
  return grid;
}

/// Returns all positions of columns x rows, row by row from the front; empty if one of them is not
/// free.
std::vector<Point> Block(const Grid& grid, Coord columns, Coord rows, const FreePositions& free) {
  std::vector<Point> block;
  for (Coord row = 0; row < rows; ++row)
    for (Coord column = 0; column < columns; ++column)
      block.push_back(grid.At(column, columns, row, rows));
  const bool fits =
      std::all_of(block.begin(), block.end(), [&](Point t) { return free.Allowed(t); });
  return fits ? block : std::vector<Point>{};
}

/// Returns the positions of the most nearly square block that is large enough, at most `count`
/// positions.
std::vector<Point> SquarestBlock(const Grid& grid, Coord count, const FreePositions& free) {
  std::vector<Point> best;
  Coord best_side = INT64_MAX;
  for (Coord columns = 1; columns <= std::min(grid.columns, count); ++columns) {
    const Coord rows = (count + columns - 1) / columns;
    const Coord side = std::max(columns * grid.dx, rows * grid.dy);
    if (rows > grid.rows || side >= best_side) continue;
    std::vector<Point> block = Block(grid, columns, rows, free);
    if (block.empty()) continue;
    best = std::move(block);
    best_side = side;
  }
  if (static_cast<Coord>(best.size()) > count) best.resize(count);
  return best;
}

/// Returns the free positions of a grid that is centred on the bed. With an odd number of columns
/// or rows, a part is in the middle; with an even number, the middle between two parts.
std::vector<Point> OnBed(const Grid& grid, Coord columns, Coord rows, const FreePositions& free) {
  std::vector<Point> places;
  for (Coord row = 0; row < rows; ++row)
    for (Coord column = 0; column < columns; ++column)
      if (const Point t = grid.At(column, columns, row, rows); free.Allowed(t)) places.push_back(t);
  return places;
}

}  // namespace

std::vector<Point> GridPositions(const Polygon& bed, const Polygon& hull, Coord distance_nm,
                                 size_t count, const std::vector<Polygon>& kept_off) {
  const Grid grid = GridOn(bed, Bounds(hull), distance_nm);
  FreePositions free(bed, hull, grid.middle);
  free.AddObstacles(kept_off);
  std::vector<Point> block = SquarestBlock(grid, count, free);
  if (block.size() == count) return block;
  std::vector<Point> most;
  for (Coord columns = grid.columns; columns >= std::max<Coord>(1, grid.columns - 1); --columns)
    for (Coord rows = grid.rows; rows >= std::max<Coord>(1, grid.rows - 1); --rows)
      if (auto places = OnBed(grid, columns, rows, free); places.size() > most.size())
        most = std::move(places);
  std::stable_sort(most.begin(), most.end(), [&](Point a, Point b) {
    return SquaredNorm(a - grid.middle) < SquaredNorm(b - grid.middle);
  });
  if (most.size() > count) most.resize(count);
  return most;
}

}  // namespace slicefarm::slicing
