#include "services/planning/algo/supports/generator/slender.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace slicefarm::planning {
namespace {

/// Connected piece of a bitmap. Its pixels share edges.
struct Piece {
  std::vector<int32_t> pixels;  ///< indices into the grid
  bool stood = false;
  /// Largest distance from a pixel of the piece to a pixel that is not set.
  PixelDistance deepest = 0;
};

/// Visits the pieces of a bitmap one by one.
class Pieces {
 public:
  Pieces(const Bitmap& bitmap, const Bitmap& stood)
      : grid_(bitmap.grid()),
        stood_(stood.Row(0)),
        open_(bitmap.Row(0), bitmap.Row(0) + bitmap.grid().size()),
        depth_(DistanceTo(Inverse(bitmap))) {}

  template <typename Visit>
  void ForEach(Visit visit) {
    for (size_t i = 0; i < open_.size(); ++i)
      if (open_[i]) visit(From(static_cast<int32_t>(i)));
  }

 private:
  static Bitmap Inverse(const Bitmap& bitmap) {
    Bitmap inverse = bitmap;
    for (size_t i = 0; i < bitmap.grid().size(); ++i) inverse.Row(0)[i] ^= 1;
    return inverse;
  }

  Piece From(int32_t first) {
    Piece piece;
    Take(first, piece);
    for (size_t i = 0; i < piece.pixels.size(); ++i) {
      const int32_t pixel = piece.pixels[i], x = pixel % grid_.width;
      if (x > 0) Take(pixel - 1, piece);
      if (x + 1 < grid_.width) Take(pixel + 1, piece);
      Take(pixel - grid_.width, piece);
      Take(pixel + grid_.width, piece);
    }
    return piece;
  }

  void Take(int32_t pixel, Piece& piece) {
    if (pixel < 0 || pixel >= std::ssize(open_) || !open_[static_cast<size_t>(pixel)]) return;
    const auto i = static_cast<size_t>(pixel);
    open_[i] = 0;
    piece.pixels.push_back(pixel);
    piece.stood |= stood_[i] != 0;
    piece.deepest = std::max(piece.deepest, depth_[i]);
  }

  const PixelGrid& grid_;
  const uint8_t* stood_;
  std::vector<uint8_t> open_;  ///< set pixels that are not yet in a piece
  std::vector<PixelDistance> depth_;
};

/// Sets the pixels within `reach` of a piece.
void SetAround(const Piece& piece, int32_t reach, Bitmap& around) {
  const PixelGrid& grid = around.grid();
  for (const int32_t pixel : piece.pixels) {
    const int32_t x = pixel % grid.width, y = pixel / grid.width;
    for (int32_t v = std::max(0, y - reach); v <= std::min(grid.height - 1, y + reach); ++v) {
      const auto half = static_cast<int32_t>(std::sqrt(reach * reach - (v - y) * (v - y)));
      const int32_t from = std::max(0, x - half), to = std::min(grid.width - 1, x + half);
      std::fill(around.Row(v) + from, around.Row(v) + to + 1, uint8_t{1});
    }
  }
}

}  // namespace

Bitmap AroundSlender(const Bitmap& bitmap, const Bitmap& stood, Coord radius_nm) {
  const PixelGrid& grid = bitmap.grid();
  Bitmap around(grid);
  Pieces(bitmap, stood).ForEach([&](const Piece& piece) {
    const Coord missing_nm = radius_nm - piece.deepest * grid.pixel_nm / kDistanceSteps;
    if (!piece.stood || missing_nm <= 0) return;
    SetAround(piece, std::max(1, static_cast<int32_t>(missing_nm / grid.pixel_nm)), around);
  });
  for (size_t i = 0; i < grid.size(); ++i) around.Row(0)[i] &= bitmap.Row(0)[i] ^ 1;
  return around;
}

}  // namespace slicefarm::planning
