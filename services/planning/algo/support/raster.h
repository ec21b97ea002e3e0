#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Square pixels over a box. Pixel (0, 0) has its lower left corner at `origin`.
struct PixelGrid {
  Point origin;
  Coord pixel_nm = 1;
  int32_t width = 0;
  int32_t height = 0;

  Point Centre(int32_t x, int32_t y) const {
    return {origin.x + x * pixel_nm + pixel_nm / 2, origin.y + y * pixel_nm + pixel_nm / 2};
  }
  /// The pixel that p lies in, or the nearest one.
  int32_t Column(Coord x) const;
  int32_t Row(Coord y) const;
  size_t size() const { return static_cast<size_t>(width) * height; }

  friend bool operator==(const PixelGrid&, const PixelGrid&) = default;
};

/// The pixels of `pixel_nm` that cover `box`, aligned to multiples of the pixel.
PixelGrid GridOver(const Box& box, Coord pixel_nm);

/// One byte a pixel: 0 or 1.
class Bitmap {
 public:
  explicit Bitmap(const PixelGrid& grid) : grid_(grid), bytes_(grid.size(), 0) {}

  const PixelGrid& grid() const { return grid_; }
  uint8_t* Row(int32_t y) { return bytes_.data() + static_cast<size_t>(y) * grid_.width; }
  const uint8_t* Row(int32_t y) const {
    return bytes_.data() + static_cast<size_t>(y) * grid_.width;
  }
  bool At(int32_t x, int32_t y) const { return Row(y)[x] != 0; }
  void Clear() { bytes_.assign(bytes_.size(), 0); }

  /// Sets the pixels whose centres lie inside of the region. Cost: O(points + rows crossed).
  void Fill(const MultiPolygon& region);
  /// Sets the pixels that the region's edges pass, to half a pixel. Cost: O(pixels set).
  void FillEdges(const MultiPolygon& region);

 private:
  PixelGrid grid_;
  std::vector<uint8_t> bytes_;
  std::vector<std::vector<int32_t>> crossings_;  ///< by row; kept for the next call
};

/// The edges of what the set pixels cover, as rings: outer ones counter-clockwise, holes clockwise;
/// pixels that share but a corner are apart. No corners along straight edges. Cost: O(pixels).
std::vector<Polygon> Outline(const Bitmap& bitmap);

/// Distances are told in steps of an eighth of a pixel, up to kFarthest.
using PixelDistance = uint8_t;
inline constexpr int kDistanceSteps = 8;
inline constexpr PixelDistance kFarthest = 31 * kDistanceSteps;

/// From each pixel's centre to the nearest set one, less half a pixel: about that to the region
/// which the bitmap was filled with. 0 in set pixels. Exact but for the rounding (Felzenszwalb,
/// Huttenlocher 2012, the separable form; the rows by brute force over the 31 pixels that count).
/// Cost: about 2 ns a pixel.
std::vector<PixelDistance> DistanceTo(const Bitmap& bitmap);

}  // namespace slicefarm::planning
