#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Area of the map that is at least a margin away from the map's boundary and holes, in mm of the
/// map.
class BoundaryMargin {
 public:
  /// REQUIRES: margin_mm > 0.
  BoundaryMargin(const SurfaceMap& map, double margin_mm);

  /// Returns true if a point is at least the margin away from the boundary.
  bool Contains(const Eigen::Vector2d& map_mm) const;
  /// Finds candidates for the points where the line from `a` to `b` enters or leaves the area, and
  /// appends them to `shares`. A candidate is a relative position on the line, from 0 to 1. The
  /// order is arbitrary.
  void Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b, std::vector<double>* shares) const;

 private:
  struct Side {
    Eigen::Vector2d from;
    Eigen::Vector2d to;
  };

  std::array<int32_t, 2> CellOf(const Eigen::Vector2d& place) const;
  std::span<const int32_t> SidesIn(int32_t column, int32_t row) const;

  double margin_mm_;
  Eigen::Vector2d low_mm_;
  double cell_mm_ = 1;
  std::array<int32_t, 2> counts_ = {1, 1};
  std::vector<Side> sides_;
  /// Index in listed_ of each cell's first side. A cell lists the sides within the margin of it.
  std::vector<int32_t> starts_;
  std::vector<int32_t> listed_;
};

}  // namespace slicefarm::texture
