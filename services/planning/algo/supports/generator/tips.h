#pragma once

#include <cstdint>
#include <vector>

#include "services/planning/algo/supports/generator/raster.h"

namespace slicefarm::planning {

/// Finds the tips of branches that are needed under a layer to support it.
///
/// The underside of each layer is given as pixels. Branches from above support the pixels near
/// them. For the remaining pixels a tip is added in the middle of the area that it would support.
class TipFinder {
 public:
  /// `reach_nm`: radius of the area that a tip supports. The grid is the grid of all pixels.
  TipFinder(const PixelGrid& grid, Coord reach_nm);

  /// Begins a layer. `underside`: pixels of the layer's underside, as ascending indices into the
  /// grid.
  void Begin(const std::vector<int32_t>& underside);
  static constexpr Coord kSpanNm = 3'200'000;

  /// Marks pixels as supported by a branch or tip at `at`: the pixels within `radius_nm`. Beads can
  /// span between `at` and an earlier supported point at most kSpanNm away, so the pixels between
  /// both are marked too.
  void Cover(Point at, Coord radius_nm);
  /// Adds tips until all pixels of the underside are supported. Returns the new tips. Cost: at most
  /// O(pixels of the underside * pixels that a tip covers), and O(tips * supported points).
  std::vector<Point> Place();

 private:
  struct Pixel {
    int32_t x = 0;
    int32_t y = 0;
  };
  Pixel At(int32_t index) const { return {index % grid_.width, index / grid_.width}; }
  /// Returns the open pixel nearest to the middle of all open pixels within sqrt(squared) pixels of
  /// `pixel`.
  Pixel MiddleAround(Pixel pixel, int32_t squared) const;
  void CoverSpan(Point a, Point b);
  /// Returns true if a tip at `tip` would support `pixel`.
  bool CoversFrom(Pixel tip, Pixel pixel) const;
  template <typename Visit>
  void ForEachWithin(Pixel centre, int32_t squared, Visit visit) const;

  PixelGrid grid_;
  Coord reach_nm_;
  int32_t reach_squared_;
  int32_t far_squared_;  ///< squared distance within which a tip may support a pixel by a span
  std::vector<int32_t> underside_;
  std::vector<uint8_t> open_;  ///< not 0 for pixels of the underside without support so far
  std::vector<Point> supporters_;
};

}  // namespace slicefarm::planning
