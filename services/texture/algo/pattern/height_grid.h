#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace slicefarm::texture {

/// Heights over a rectangle that repeats in both directions. Each cell between four nodes is
/// divided into two triangles, on which the height is linear.
struct HeightGrid {
  int32_t columns = 0;  ///< number of nodes in x per period; node `columns` equals node 0
  int32_t rows = 0;
  Eigen::Vector2d size_mm = Eigen::Vector2d::Zero();
  /// heights of the nodes: rows * columns, row by row from the lower left corner
  std::vector<double> heights_mm;

  /// Returns the height of a node; indices are periodic.
  double NodeMm(int32_t column, int32_t row) const {
    const auto wrap = [](int32_t i, int32_t n) { return (i % n + n) % n; };
    return heights_mm[static_cast<size_t>(wrap(row, rows)) * columns + wrap(column, columns)];
  }
  /// Returns the position of a node.
  Eigen::Vector2d NodePosition(int32_t column, int32_t row) const {
    return {size_mm.x() * column / columns, size_mm.y() * row / rows};
  }
  /// Returns true if the diagonal of the cell at the upper right of a node begins at this node;
  /// false if it connects the two other corners. The diagonal with the smaller height difference is
  /// used, so that ridges stay ridges.
  bool CutFromNode(int32_t column, int32_t row) const;

  /// Returns the height at any position; positions outside of the rectangle are periodic. Cost:
  /// O(1).
  double At(const Eigen::Vector2d& place_mm) const;
};

}  // namespace slicefarm::texture
