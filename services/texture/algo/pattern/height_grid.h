#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace slicefarm::texture {

/// Heights over a rectangle that repeats in both directions, linear on two triangles for each cell.
struct HeightGrid {
  int32_t columns = 0;  ///< nodes in a period: the next one is the first again
  int32_t rows = 0;
  Eigen::Vector2d size_mm = Eigen::Vector2d::Zero();
  std::vector<double> heights_mm;  ///< rows * columns, row by row from the lower left corner

  double NodeMm(int32_t column, int32_t row) const {
    const auto wrap = [](int32_t i, int32_t n) { return (i % n + n) % n; };
    return heights_mm[static_cast<size_t>(wrap(row, rows)) * columns + wrap(column, columns)];
  }
  Eigen::Vector2d NodePlace(int32_t column, int32_t row) const {
    return {size_mm.x() * column / columns, size_mm.y() * row / rows};
  }
  /// Whether the cell right above a node is cut from there to the opposite corner, or between the
  /// other two: the diagonal of less difference, so that ridges stay ridges.
  bool CutFromNode(int32_t column, int32_t row) const;

  /// The height over any place. Cost: O(1).
  double At(const Eigen::Vector2d& place_mm) const;
};

}  // namespace slicefarm::texture
