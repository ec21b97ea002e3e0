#include "services/infill/algo/space_filling/cell_cover.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::infill {
namespace {

/// Cell of the origin: its binary digits alternate between 0 and 1, its ternary digits are all 1.
constexpr uint32_t kMiddleOfTwos = 0x15555555;
constexpr uint32_t kMiddleOfThrees = 193'710'244;  // (3^18 - 1) / 2

Coord FloorDiv(Coord a, Coord b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Calls visit(column, row) for all cells that the segment ab meets, and for some cells beside
/// them.
template <typename Visit>
void ForEachCellOn(Point a, Point b, const CellCover& cover, Visit visit) {
  const auto cell = static_cast<double>(cover.cell_nm);
  if (a.y > b.y) std::swap(a, b);
  const double x0 = static_cast<double>(a.x - cover.origin.x) / cell;
  const double y0 = static_cast<double>(a.y - cover.origin.y) / cell;
  const double x1 = static_cast<double>(b.x - cover.origin.x) / cell;
  const double y1 = static_cast<double>(b.y - cover.origin.y) / cell;
  constexpr double kRounding = 1e-6;
  const double slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0;
  for (auto row = static_cast<int32_t>(std::floor(y0 - kRounding)); row <= y1 + kRounding; ++row) {
    double from = x0, to = x1;
    if (y1 > y0) {
      from = x0 + slope * (std::max(y0, static_cast<double>(row)) - y0);
      to = x0 + slope * (std::min(y1, static_cast<double>(row) + 1) - y0);
    }
    if (from > to) std::swap(from, to);
    for (auto column = static_cast<int32_t>(std::floor(from - kRounding)); column <= to + kRounding;
         ++column) {
      visit(column, row);
    }
  }
}

/// Returns the crossings of the region's edges with the centre line of each row, in cells from the
/// origin.
std::vector<std::vector<double>> Crossings(const MultiPolygon& region, const CellCover& cover) {
  std::vector<std::vector<double>> crossings(cover.rows);
  const auto cell = static_cast<double>(cover.cell_nm);
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a.y > b.y) std::swap(a, b);
      const double y0 = static_cast<double>(a.y - cover.origin.y) / cell - 0.5;
      const double y1 = static_cast<double>(b.y - cover.origin.y) / cell - 0.5;
      for (auto row = static_cast<int32_t>(std::ceil(y0)); row < y1; ++row) {
        const double part = (row - y0) / (y1 - y0);
        crossings[row].push_back(
            (static_cast<double>(a.x - cover.origin.x) + part * static_cast<double>(b.x - a.x)) /
            cell);
      }
    }
  });
  for (std::vector<double>& row : crossings) std::sort(row.begin(), row.end());
  return crossings;
}

/// One level of a quadtree: for each block, 1 if all of its cells are inside.
struct Level {
  uint32_t side = 1;  ///< side of a block, in cells
  uint32_t first_x = 0;
  uint32_t first_y = 0;
  int32_t columns = 0;
  int32_t rows = 0;
  std::vector<char> full;

  bool Has(uint32_t x, uint32_t y) const {
    if (x < first_x || y < first_y) return false;
    const uint32_t column = x - first_x, row = y - first_y;
    return column < static_cast<uint32_t>(columns) && row < static_cast<uint32_t>(rows) &&
           full[static_cast<size_t>(row) * columns + column] != 0;
  }
};

Level Coarser(const Level& fine, uint32_t base) {
  Level level{fine.side * base, fine.first_x / base, fine.first_y / base, 0, 0, {}};
  level.columns =
      static_cast<int32_t>((fine.first_x + fine.columns - 1) / base - level.first_x) + 1;
  level.rows = static_cast<int32_t>((fine.first_y + fine.rows - 1) / base - level.first_y) + 1;
  level.full.assign(static_cast<size_t>(level.columns) * level.rows, 1);
  for (int32_t row = 0; row < level.rows; ++row) {
    for (int32_t column = 0; column < level.columns; ++column) {
      char& full = level.full[static_cast<size_t>(row) * level.columns + column];
      for (uint32_t k = 0; k < base * base && full != 0; ++k) {
        full = fine.Has((level.first_x + column) * base + k % base,
                        (level.first_y + row) * base + k / base)
                   ? 1
                   : 0;
      }
    }
  }
  return level;
}

/// Directions right, up, left, down: along a cell's lower, right, upper and left side, with the
/// cell on the left.
constexpr std::array<Point, 4> kWays = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

}  // namespace

CellCover CoverOf(const MultiPolygon& region, Coord cell_nm, uint32_t base) {
  CellCover cover{.cell_nm = cell_nm};
  if (region.empty()) return cover;
  const Box box = Bounds(region);
  const uint32_t middle = base == 3 ? kMiddleOfThrees : kMiddleOfTwos;
  const Coord left = FloorDiv(box.min.x, cell_nm), low = FloorDiv(box.min.y, cell_nm);
  cover.origin = {left * cell_nm, low * cell_nm};
  cover.first = {static_cast<uint32_t>(middle + left), static_cast<uint32_t>(middle + low)};
  cover.columns = static_cast<int32_t>(FloorDiv(box.max.x, cell_nm) - left) + 1;
  cover.rows = static_cast<int32_t>(FloorDiv(box.max.y, cell_nm) - low) + 1;
  cover.inside.assign(static_cast<size_t>(cover.columns) * cover.rows, 0);
  const std::vector<std::vector<double>> crossings = Crossings(region, cover);
  for (int32_t row = 0; row < cover.rows; ++row) {
    for (size_t k = 0; k + 1 < crossings[row].size(); k += 2) {
      const auto from = static_cast<int32_t>(std::ceil(crossings[row][k] - 0.5));
      for (int32_t column = std::max(from, 0);
           column < cover.columns && column + 0.5 < crossings[row][k + 1]; ++column) {
        cover.inside[static_cast<size_t>(row) * cover.columns + column] = 1;
      }
    }
  }
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      ForEachCellOn(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], cover,
                    [&](int32_t column, int32_t row) {
                      if (cover.Has(column, row))
                        cover.inside[static_cast<size_t>(row) * cover.columns + column] = 0;
                    });
    }
  });
  return cover;
}

std::vector<CellBlock> LargestBlocks(const CellCover& cover, uint32_t base) {
  std::vector<CellBlock> blocks;
  Level level{1, cover.first.x, cover.first.y, cover.columns, cover.rows, cover.inside};
  while (std::find(level.full.begin(), level.full.end(), 1) != level.full.end()) {
    Level coarser = Coarser(level, base);
    for (int32_t row = 0; row < level.rows; ++row) {
      for (int32_t column = 0; column < level.columns; ++column) {
        const uint32_t x = level.first_x + column, y = level.first_y + row;
        if (level.Has(x, y) && !coarser.Has(x / base, y / base))
          blocks.push_back({{x * level.side, y * level.side}, level.side});
      }
    }
    level = std::move(coarser);
  }
  return blocks;
}

std::vector<Polygon> OutlineOf(const CellCover& cover) {
  // Sides of cells on the cover's outline that are already in a ring, by cell and direction.
  std::vector<char> open(4 * cover.inside.size(), 0);
  const auto at = [&](int32_t column, int32_t row, int path) -> char& {
    return open[4 * (static_cast<size_t>(row) * cover.columns + column) + path];
  };
  const auto is_edge = [&](int32_t column, int32_t row, int path) {
    // The neighbour is to the right of the direction.
    const Point beyond = kWays[(path + 3) % 4];
    return cover.Has(column, row) && !cover.Has(column + static_cast<int32_t>(beyond.x),
                                                row + static_cast<int32_t>(beyond.y));
  };
  std::vector<Polygon> rings;
  for (int32_t row = 0; row < cover.rows; ++row) {
    for (int32_t column = 0; column < cover.columns; ++column) {
      for (int first_path = 0; first_path < 4; ++first_path) {
        if (!is_edge(column, row, first_path) || at(column, row, first_path) != 0) continue;
        Polygon& ring = rings.emplace_back();
        int32_t x = column, y = row;
        int path = first_path;
        while (at(x, y, path) == 0) {
          at(x, y, path) = 1;
          // The ring continues from the end of this side: along the cell's next side if that is on
          // the outline, else straight on, or to the right around the cell there.
          const Point ahead = kWays[path];
          const auto ahead_x = static_cast<int32_t>(ahead.x),
                     ahead_y = static_cast<int32_t>(ahead.y);
          int next = (path + 1) % 4;
          if (is_edge(x, y, next)) {
            // The ring stays at this cell.
          } else if (is_edge(x + ahead_x, y + ahead_y, path)) {
            x += ahead_x, y += ahead_y;
            next = path;
          } else {
            const Point beyond = kWays[(path + 3) % 4];
            x += ahead_x + static_cast<int32_t>(beyond.x);
            y += ahead_y + static_cast<int32_t>(beyond.y);
            next = (path + 3) % 4;
          }
          if (next != path) {
            // Corner at which side `next` of cell (x, y) starts.
            const Coord dx = next == 1 || next == 2 ? 1 : 0, dy = next >= 2 ? 1 : 0;
            ring.push_back({cover.origin.x + (x + dx) * cover.cell_nm,
                            cover.origin.y + (y + dy) * cover.cell_nm});
          }
          path = next;
        }
      }
    }
  }
  return rings;
}

}  // namespace slicefarm::infill
