#include "services/texture/algo/paths/tiled_section.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::texture {
namespace {

Eigen::Vector2d TileAt(const Eigen::Vector2d& place, const Eigen::Vector2d& tile_mm) {
  return {std::floor(place.x() / tile_mm.x()), std::floor(place.y() / tile_mm.y())};
}

/// Returns a position in the tile's own coordinates, slightly inside the tile's border. Exactly on
/// the border, the line could miss the outlines of both tiles.
Eigen::Vector2d WithinTile(const Eigen::Vector2d& place, const Eigen::Vector2d& tile,
                           const Eigen::Vector2d& tile_mm) {
  const Eigen::Vector2d trifle = 1e-11 * tile_mm;
  return (place - tile.cwiseProduct(tile_mm)).cwiseMax(trifle).cwiseMin(tile_mm - trifle);
}

/// Adds the relative positions from `a` to `b` that are multiples of `step`.
void AddBorders(double a, double b, double step, std::vector<double>* shares) {
  if (a == b) return;
  const auto first = static_cast<int64_t>(std::ceil(std::min(a, b) / step));
  const auto last = static_cast<int64_t>(std::floor(std::max(a, b) / step));
  for (int64_t i = first; i <= last; ++i) {
    const double share = (static_cast<double>(i) * step - a) / (b - a);
    if (share > 0 && share < 1) shares->push_back(share);
  }
}

}  // namespace

bool TiledSection::Contains(const Eigen::Vector2d& map_mm) const {
  const Eigen::Vector2d place = placement_.ToTexture(map_mm);
  const Eigen::Vector2d tile = TileAt(place, tile_mm_);
  return IsThere(tile) && section_->Contains(WithinTile(place, tile, tile_mm_));
}

void TiledSection::Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        std::vector<double>* shares) const {
  const Eigen::Vector2d from = placement_.ToTexture(a), to = placement_.ToTexture(b);
  const Eigen::Vector2d first_tile = TileAt(from, tile_mm_);
  const size_t before = shares->size();
  if (first_tile == TileAt(to, tile_mm_)) {
    if (IsThere(first_tile))
      section_->Crossings(WithinTile(from, first_tile, tile_mm_),
                          WithinTile(to, first_tile, tile_mm_), shares);
    return;
  }
  for (const int axis : {0, 1}) AddBorders(from[axis], to[axis], tile_mm_[axis], shares);
  std::vector<double> borders(shares->begin() + static_cast<int64_t>(before), shares->end());
  borders.push_back(1);
  std::sort(borders.begin(), borders.end());
  double begin = 0;
  for (const double end : borders) {
    const Eigen::Vector2d p = from + begin * (to - from), q = from + end * (to - from);
    const Eigen::Vector2d tile = TileAt((p + q) / 2, tile_mm_);
    if (IsThere(tile)) {
      const size_t of_piece = shares->size();
      section_->Crossings(WithinTile(p, tile, tile_mm_), WithinTile(q, tile, tile_mm_), shares);
      for (size_t i = of_piece; i < shares->size(); ++i)
        (*shares)[i] = begin + (*shares)[i] * (end - begin);
    }
    begin = end;
  }
}

}  // namespace slicefarm::texture
