#include "services/texture/algo/pattern/height_grid.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::texture {
namespace {

/// Cell that contains a position (in one of the two axes), and the relative position in the cell.
struct CellShare {
  int32_t cell = 0;
  double share = 0;
};

CellShare CellOf(double place, double size, int32_t count) {
  const double turns = place / size;
  const double cells = (turns - std::floor(turns)) * count;
  const auto cell = std::min(static_cast<int32_t>(cells), count - 1);
  return {cell, cells - cell};
}

}  // namespace

bool HeightGrid::CutFromNode(int32_t column, int32_t row) const {
  const double rising = std::abs(NodeMm(column, row) - NodeMm(column + 1, row + 1));
  const double falling = std::abs(NodeMm(column + 1, row) - NodeMm(column, row + 1));
  return rising <= falling;
}

double HeightGrid::At(const Eigen::Vector2d& place_mm) const {
  const auto [i, x] = CellOf(place_mm.x(), size_mm.x(), columns);
  const auto [k, y] = CellOf(place_mm.y(), size_mm.y(), rows);
  const double h00 = NodeMm(i, k), h10 = NodeMm(i + 1, k);
  const double h01 = NodeMm(i, k + 1), h11 = NodeMm(i + 1, k + 1);
  if (CutFromNode(i, k))
    return x >= y ? h00 + x * (h10 - h00) + y * (h11 - h10)
                  : h00 + y * (h01 - h00) + x * (h11 - h01);
  return x + y <= 1 ? h00 + x * (h10 - h00) + y * (h01 - h00)
                    : h11 + (1 - x) * (h01 - h11) + (1 - y) * (h10 - h11);
}

}  // namespace slicefarm::texture
