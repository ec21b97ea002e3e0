#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/pattern/texture.h"

namespace slicefarm::texture {

/// Side of a section's outline, with the solid on its left.
struct OutlineSide {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// Solid area of a texture's tile at one height. Its outlines are stored as sides, in any order, in
/// a grid for queries by position.
class Section {
 public:
  Section(std::vector<OutlineSide> sides, const Eigen::Vector2d& tile_mm);

  /// Returns the sides of the outlines.
  std::span<const OutlineSide> sides() const { return sides_; }
  /// Returns the area of the section in one tile.
  double AreaMm2() const;

  /// Returns true if a position of the tile is solid, by the winding number of the outlines.
  bool Contains(const Eigen::Vector2d& place_mm) const;

  /// Finds the points where the line from `a` to `b`, both in the tile, crosses outlines. Appends
  /// their relative positions on the line, from 0 to 1, to `shares`. For a side along the line,
  /// these are both ends of the side. The order is arbitrary, and positions may occur twice. Cost:
  /// O(1 + sides near the line).
  void Crossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                 std::vector<double>* shares) const;

 private:
  int32_t CellOf(double place, int axis) const;
  std::span<const int32_t> SidesIn(int32_t column, int32_t row) const;

  std::vector<OutlineSide> sides_;
  Eigen::Vector2d cell_mm_;
  std::array<int32_t, 2> counts_ = {1, 1};
  std::vector<int32_t> starts_;  ///< Index in listed_ of each cell's first side.
  std::vector<int32_t> listed_;
};

/// Returns one section for each of `heights_mm`, in their order. REQUIRES: all heights are above 0.
/// Points exactly at a height count as above it. Cost: O(t + s) for t triangles and s sides of the
/// results.
std::vector<Section> SectionsOf(const Texture& texture, std::span<const double> heights_mm);

}  // namespace slicefarm::texture
