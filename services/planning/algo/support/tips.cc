#include "services/planning/algo/support/tips.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::planning {
namespace {

int32_t SquaredPixels(Coord length_nm, Coord pixel_nm) {
  const double pixels = static_cast<double>(length_nm) / static_cast<double>(pixel_nm);
  return static_cast<int32_t>(pixels * pixels);
}

}  // namespace

TipPlaces::TipPlaces(const PixelGrid& grid, Coord reach_nm)
    : grid_(grid),
      reach_nm_(reach_nm),
      reach_squared_(SquaredPixels(reach_nm, grid.pixel_nm)),
      open_(grid.size(), 0) {}

template <typename Visit>
void TipPlaces::ForEachWithin(Pixel centre, int32_t squared, Visit visit) const {
  const auto reach = static_cast<int32_t>(std::sqrt(squared));
  for (int32_t y = std::max(0, centre.y - reach); y <= std::min(grid_.height - 1, centre.y + reach);
       ++y)
    for (int32_t x = std::max(0, centre.x - reach);
         x <= std::min(grid_.width - 1, centre.x + reach); ++x)
      if ((x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y) <= squared)
        visit(y * grid_.width + x);
}

void TipPlaces::Begin(const std::vector<int32_t>& underside) {
  for (const int32_t i : underside_) open_[static_cast<size_t>(i)] = 0;
  underside_ = underside;
  for (const int32_t i : underside_) open_[static_cast<size_t>(i)] = 1;
}

void TipPlaces::Cover(Point at, Coord radius_nm) {
  ForEachWithin({grid_.Column(at.x), grid_.Row(at.y)}, SquaredPixels(radius_nm, grid_.pixel_nm),
                [&](int32_t i) { open_[static_cast<size_t>(i)] = 0; });
}

TipPlaces::Pixel TipPlaces::MiddleAround(Pixel pixel) const {
  int64_t sum_x = 0, sum_y = 0, count = 0;
  ForEachWithin(pixel, reach_squared_, [&](int32_t i) {
    if (!open_[static_cast<size_t>(i)]) return;
    sum_x += At(i).x;
    sum_y += At(i).y;
    ++count;
  });
  Pixel best = pixel;
  int64_t least = INT64_MAX;
  ForEachWithin(pixel, reach_squared_, [&](int32_t i) {
    if (!open_[static_cast<size_t>(i)]) return;
    const int64_t dx = At(i).x * count - sum_x, dy = At(i).y * count - sum_y;
    if (dx * dx + dy * dy >= least) return;
    least = dx * dx + dy * dy;
    best = At(i);
  });
  return best;
}

std::vector<Point> TipPlaces::Place() {
  std::vector<Point> tips;
  for (const int32_t i : underside_) {
    while (open_[static_cast<size_t>(i)]) {
      const Pixel middle = MiddleAround(At(i));
      tips.push_back(grid_.Centre(middle.x, middle.y));
      Cover(tips.back(), reach_nm_);
    }
  }
  return tips;
}

}  // namespace slicefarm::planning
