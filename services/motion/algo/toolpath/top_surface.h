#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/point.h"
#include "common/model/layers/surface_facet.h"

namespace slicefarm::motion {

/// Place on an object's upper side.
struct SurfacePlace {
  double up_nm = 0;      ///< height above the layer's top
  double slope_rad = 0;  ///< angle between the surface and the horizontal
};

/// Upper side of an object near a layer, for queries about single points.
class TopSurface {
 public:
  /// `facets` must outlive this object; fewer than 2^29. `reach_nm`: least distance for IsNear.
  /// Grid squares are wider if many facets are large, so that memory is O(facets). Cost:
  /// O(n log n), n facets.
  TopSurface(std::span<const SurfaceFacet> facets, Coord reach_nm);

  /// Returns the highest place above or below a point with a height in [low_nm, high_nm]. Cost:
  /// O(facets in the point's grid square with a corner above the result). Level facets above each
  /// other cost O(1).
  std::optional<SurfacePlace> At(Point point, double low_nm, double high_nm) const;

  /// Returns true if a facet may be within the reach of a point. Cost: O(1).
  bool IsNear(Point point) const;

 private:
  struct Square {
    int64_t column = 0, row = 0;
  };
  /// Rectangle of grid squares.
  struct Squares {
    Square low, high;
    /// Returns the number of squares.
    int64_t Count() const { return (high.row - low.row + 1) * (high.column - low.column + 1); }
  };
  void ChooseSide(std::span<const uint32_t> listed, Coord reach_nm);
  void ListFacets(std::span<const uint32_t> listed);
  Squares SquaresOf(const SurfaceFacet& facet) const;
  Square SquareOf(Point point) const;
  std::span<const uint32_t> FacetsIn(Square square) const;

  std::span<const SurfaceFacet> facets_;
  Box bounds_;
  Coord side_nm_ = 0;  ///< side of a grid square
  int64_t columns_ = 0, rows_ = 0;
  std::vector<uint32_t> first_;    ///< first element of `members_` of each square, and the end
  std::vector<uint32_t> members_;  ///< indices of facets, square by square, highest corner first
};

}  // namespace slicefarm::motion
