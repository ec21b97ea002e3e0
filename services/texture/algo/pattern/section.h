#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/pattern/texture.h"

namespace slicefarm::texture {

/// A side of a section's outline, the solid on its left.
struct OutlineSide {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};

/// Where a texture's tile is solid, at one height: outlines as sides in any order, found by place.
class Section {
 public:
  Section(std::vector<OutlineSide> sides, const Eigen::Vector2d& tile_mm);

  std::span<const OutlineSide> sides() const { return sides_; }
  double AreaMm2() const;

  /// Whether a place of the tile is solid: the outlines wind around it.
  bool Contains(const Eigen::Vector2d& place_mm) const;

  /// Adds the shares of the way from `a` to `b`, both in the tile, at which it crosses outlines, or
  /// runs along one that ends, in any order; some may be there twice. Cost: O(1 + sides near the
  /// way).
  void Crossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                 std::vector<double>* shares) const;

 private:
  int32_t CellOf(double place, int axis) const;
  std::span<const int32_t> SidesIn(int32_t column, int32_t row) const;

  std::vector<OutlineSide> sides_;
  Eigen::Vector2d cell_mm_;
  std::array<int32_t, 2> counts_ = {1, 1};
  std::vector<int32_t> starts_;  ///< by cell, into listed_
  std::vector<int32_t> listed_;
};

/// Sections at heights, in order, all above 0. What lies at a height belongs above it. Cost: O(t +
/// sides) for t triangles.
std::vector<Section> SectionsOf(const Texture& texture, std::span<const double> heights_mm);

}  // namespace slicefarm::texture
