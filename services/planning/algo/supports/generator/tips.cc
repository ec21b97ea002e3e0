#include "services/planning/algo/supports/generator/tips.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

int32_t SquaredPixels(Coord length_nm, Coord pixel_nm) {
  const double pixels = static_cast<double>(length_nm) / static_cast<double>(pixel_nm);
  return static_cast<int32_t>(pixels * pixels);
}

/// Half width of the strip that beads support between two tips.
constexpr Coord kBesideSpanNm = 800'000;

}  // namespace

TipFinder::TipFinder(const PixelGrid& grid, Coord reach_nm)
    : grid_(grid),
      reach_nm_(reach_nm),
      reach_squared_(SquaredPixels(reach_nm, grid.pixel_nm)),
      far_squared_(SquaredPixels(reach_nm * 7 / 4, grid.pixel_nm)),
      open_(grid.size(), 0) {}

template <typename Visit>
void TipFinder::ForEachWithin(Pixel centre, int32_t squared, Visit visit) const {
  const auto reach = static_cast<int32_t>(std::sqrt(squared));
  for (int32_t y = std::max(0, centre.y - reach); y <= std::min(grid_.height - 1, centre.y + reach);
       ++y)
    for (int32_t x = std::max(0, centre.x - reach);
         x <= std::min(grid_.width - 1, centre.x + reach); ++x)
      if ((x - centre.x) * (x - centre.x) + (y - centre.y) * (y - centre.y) <= squared)
        visit(y * grid_.width + x);
}

void TipFinder::Begin(const std::vector<int32_t>& underside) {
  for (const int32_t i : underside_) open_[static_cast<size_t>(i)] = 0;
  underside_ = underside;
  for (const int32_t i : underside_) open_[static_cast<size_t>(i)] = 1;
  supporters_.clear();
}

void TipFinder::Cover(Point at, Coord radius_nm) {
  bool supports = false;
  ForEachWithin({grid_.Column(at.x), grid_.Row(at.y)}, SquaredPixels(radius_nm, grid_.pixel_nm),
                [&](int32_t i) {
                  supports |= open_[static_cast<size_t>(i)] != 0;
                  open_[static_cast<size_t>(i)] = 0;
                });
  if (!supports) return;
  for (const Point other : supporters_)
    if (Distance(at, other) <= kSpanNm) CoverSpan(at, other);
  supporters_.push_back(at);
}

void TipFinder::CoverSpan(Point a, Point b) {
  const int32_t x0 = grid_.Column(std::min(a.x, b.x) - kBesideSpanNm);
  const int32_t x1 = grid_.Column(std::max(a.x, b.x) + kBesideSpanNm);
  for (int32_t y = grid_.Row(std::min(a.y, b.y) - kBesideSpanNm);
       y <= grid_.Row(std::max(a.y, b.y) + kBesideSpanNm); ++y)
    for (int32_t x = x0; x <= x1; ++x)
      if (uint8_t& open = open_[static_cast<size_t>(y * grid_.width + x)];
          open && DistanceToSegment(grid_.Centre(x, y), a, b) <= kBesideSpanNm)
        open = 0;
}

TipFinder::Pixel TipFinder::MiddleAround(Pixel pixel, int32_t squared) const {
  int64_t sum_x = 0, sum_y = 0, count = 0;
  ForEachWithin(pixel, squared, [&](int32_t i) {
    if (!open_[static_cast<size_t>(i)]) return;
    sum_x += At(i).x;
    sum_y += At(i).y;
    ++count;
  });
  Pixel best = pixel;
  int64_t least = INT64_MAX;
  ForEachWithin(pixel, squared, [&](int32_t i) {
    if (!open_[static_cast<size_t>(i)]) return;
    const int64_t dx = At(i).x * count - sum_x, dy = At(i).y * count - sum_y;
    if (dx * dx + dy * dy >= least) return;
    least = dx * dx + dy * dy;
    best = At(i);
  });
  return best;
}

bool TipFinder::CoversFrom(Pixel tip, Pixel pixel) const {
  const Point at = grid_.Centre(tip.x, tip.y), p = grid_.Centre(pixel.x, pixel.y);
  if (Distance(at, p) <= reach_nm_) return true;
  return std::ranges::any_of(supporters_, [&](Point other) {
    return Distance(at, other) <= kSpanNm && DistanceToSegment(p, at, other) <= kBesideSpanNm;
  });
}

std::vector<Point> TipFinder::Place() {
  std::vector<Point> tips;
  const auto put = [&](Pixel pixel) {
    tips.push_back(grid_.Centre(pixel.x, pixel.y));
    Cover(tips.back(), reach_nm_);
  };
  for (const int32_t i : underside_) {
    const uint8_t& open = open_[static_cast<size_t>(i)];
    if (!open) continue;
    if (const Pixel far = MiddleAround(At(i), far_squared_); CoversFrom(far, At(i))) put(far);
    while (open) put(MiddleAround(At(i), reach_squared_));
  }
  return tips;
}

}  // namespace slicefarm::planning
