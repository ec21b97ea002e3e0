#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Grid of square pixels. The lower left corner of pixel (0, 0) is `origin`.
struct PixelGrid {
  Point origin;
  Coord pixel_nm = 1;
  int32_t width = 0;
  int32_t height = 0;

  /// Returns the centre of the pixel in column `x` and row `y`.
  Point Centre(int32_t x, int32_t y) const {
    return {origin.x + x * pixel_nm + pixel_nm / 2, origin.y + y * pixel_nm + pixel_nm / 2};
  }
  /// Returns the index of the column that contains the coordinate `x`; outside of the grid, the
  /// nearest column.
  int32_t Column(Coord x) const;
  /// Returns the index of the row that contains the coordinate `y`; outside of the grid, the
  /// nearest row.
  int32_t Row(Coord y) const;
  size_t size() const { return static_cast<size_t>(width) * height; }

  friend bool operator==(const PixelGrid&, const PixelGrid&) = default;
};

/// Returns the grid with pixels of side `pixel_nm` that covers `box`. The pixels are aligned to
/// multiples of their side.
PixelGrid GridOver(const Box& box, Coord pixel_nm);

/// Bitmap with one byte per pixel, row by row: 0 or 1.
class Bitmap {
 public:
  /// Creates a bitmap with all pixels 0.
  explicit Bitmap(const PixelGrid& grid) : grid_(grid), bytes_(grid.size(), 0) {}

  const PixelGrid& grid() const { return grid_; }
  /// Returns the bytes of row `y`, one per column.
  uint8_t* Row(int32_t y) { return bytes_.data() + static_cast<size_t>(y) * grid_.width; }
  const uint8_t* Row(int32_t y) const {
    return bytes_.data() + static_cast<size_t>(y) * grid_.width;
  }
  /// Returns true if the pixel is set.
  bool At(int32_t x, int32_t y) const { return Row(y)[x] != 0; }
  /// Sets all pixels to 0.
  void Clear() { bytes_.assign(bytes_.size(), 0); }

  /// Sets the pixels with their centres inside the region. Cost: O(points + rows crossed).
  void Fill(const MultiPolygon& region);
  /// Sets the pixels that the region's edges cross, exact to half a pixel. Cost: O(pixels set).
  void FillEdges(const MultiPolygon& region);

 private:
  PixelGrid grid_;
  std::vector<uint8_t> bytes_;
  /// crossings per row; a member so that calls reuse the memory
  std::vector<std::vector<int32_t>> crossings_;
};

/// Returns the boundaries of the set pixels as rings. Outer rings are counter-clockwise, holes
/// clockwise. Pixels that share only a corner are separate. Straight sides have no points in
/// between. Cost: O(pixels).
std::vector<Polygon> Outline(const Bitmap& bitmap);

/// Distance in eighths of a pixel (kDistanceSteps), at most kFarthest.
using PixelDistance = uint8_t;
inline constexpr int kDistanceSteps = 8;
inline constexpr PixelDistance kFarthest = 31 * kDistanceSteps;

/// Returns, for each pixel, the distance from its centre to the centre of the nearest set pixel,
/// less half a pixel. This is about the distance to the region that filled the bitmap. It is 0 in
/// set pixels. The result is exact except for rounding. Method: Felzenszwalb, Huttenlocher 2012,
/// the separable form. In rows, all pixels up to the largest distance (31 pixels) are compared.
/// Cost: about 2 ns per pixel.
std::vector<PixelDistance> DistanceTo(const Bitmap& bitmap);

}  // namespace slicefarm::planning
