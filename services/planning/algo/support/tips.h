#pragma once

#include <cstdint>
#include <vector>

#include "services/planning/algo/support/raster.h"

namespace slicefarm::planning {

/// Places under a layer that carry it.
///
/// Of each layer the underside is known as pixels. Carriers that come from above cover what is near
/// them; where something is left, a tip is put in the middle of what it would cover.
class TipPlaces {
 public:
  /// `reach_nm`: what a tip covers around its middle.
  TipPlaces(const PixelGrid& grid, Coord reach_nm);

  /// Begins a layer, whose underside are these pixels (indices into the grid, ascending).
  void Begin(const std::vector<int32_t>& underside);
  static constexpr Coord kSpanNm = 3'200'000;

  /// All within `radius_nm` of a place is carried, and what spans from there to the places before.
  void Cover(Point at, Coord radius_nm);
  /// Puts tips until all is covered; returns their places, in order of the pixels.
  /// Cost: O(pixels of the underside * pixels that a tip covers) at most, and O(tips * places).
  std::vector<Point> Place();

 private:
  struct Pixel {
    int32_t x = 0;
    int32_t y = 0;
  };
  Pixel At(int32_t index) const { return {index % grid_.width, index / grid_.width}; }
  /// The middle of what is open within sqrt(squared) pixels.
  Pixel MiddleAround(Pixel pixel, int32_t squared) const;
  void CoverSpan(Point a, Point b);
  /// Whether a tip there would cover the pixel.
  bool CoversFrom(Pixel tip, Pixel pixel) const;
  template <typename Visit>
  void ForEachWithin(Pixel centre, int32_t squared, Visit visit) const;

  PixelGrid grid_;
  Coord reach_nm_;
  int32_t reach_squared_;
  int32_t far_squared_;  ///< the same, of where a tip may be that covers a pixel by a span
  std::vector<int32_t> underside_;
  std::vector<uint8_t> open_;  ///< of the underside, and not yet carried
  std::vector<Point> carriers_;
};

}  // namespace slicefarm::planning
