#include "services/motion/algo/toolpath/top_surface.h"

#include <algorithm>
#include <functional>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

/// Largest number of squares in a row or column.
constexpr Coord kMostSquares = 512;
/// Largest mean number of squares in which a facet is listed, and a number for all facets together.
constexpr int64_t kMembersPerFacet = 4;
constexpr int64_t kSpareMembers = int64_t{1} << 20;

Box BoundsOf(const SurfaceFacet& facet) {
  Box box;
  for (const Point corner : facet.corners) box.Add(corner);
  return box;
}

/// Returns twice the area of a facet as seen from above, in nm^2.
double TwiceArea(const SurfaceFacet& facet) {
  const auto& [a, b, c] = facet.corners;
  return Cross(b - a, c - a);
}

Coord HighestOf(const SurfaceFacet& facet) { return std::ranges::max(facet.up_nm); }

/// Returns the indices of the facets with an area, sorted by their highest corners, from the top
/// down.
std::vector<uint32_t> HighestFirst(std::span<const SurfaceFacet> facets) {
  std::vector<uint32_t> order;
  order.reserve(facets.size());
  for (uint32_t i = 0; i < facets.size(); ++i)
    if (TwiceArea(facets[i]) > 0) order.push_back(i);
  std::ranges::stable_sort(order, std::greater(), [&](uint32_t i) { return HighestOf(facets[i]); });
  return order;
}

/// Returns the place of a facet above a point, or nothing if the point is beside the facet.
std::optional<SurfacePlace> PlaceOn(const SurfaceFacet& facet, Point point) {
  const auto& [a, b, c] = facet.corners;
  const double whole = TwiceArea(facet);
  const double at_a = Cross(c - b, point - b), at_b = Cross(a - c, point - c);
  const double at_c = Cross(b - a, point - a);
  if (at_a < 0 || at_b < 0 || at_c < 0) return std::nullopt;
  const auto up = [&](size_t corner) { return static_cast<double>(facet.up_nm[corner]); };
  const double rise_b = up(1) - up(0), rise_c = up(2) - up(0);
  const auto gradient = [&](Coord of_b, Coord of_c) {
    return (rise_b * static_cast<double>(of_c) - rise_c * static_cast<double>(of_b)) / whole;
  };
  const double slope = Hypot(gradient(b.y - a.y, c.y - a.y), gradient(b.x - a.x, c.x - a.x));
  return SurfacePlace{up(0) + (at_b * rise_b + at_c * rise_c) / whole, Atan2(slope, 1)};
}

}  // namespace

TopSurface::TopSurface(std::span<const SurfaceFacet> facets, Coord reach_nm) : facets_(facets) {
  const std::vector<uint32_t> listed = HighestFirst(facets);
  for (const uint32_t i : listed) bounds_.Add(BoundsOf(facets[i]));
  if (listed.empty()) return;
  ChooseSide(listed, reach_nm);
  ListFacets(listed);
}

/// Chooses the side of the squares. Many large facets in small squares would fill the memory, and
/// their number would not fit into the index.
void TopSurface::ChooseSide(std::span<const uint32_t> listed, Coord reach_nm) {
  const Coord width = bounds_.max.x - bounds_.min.x, depth = bounds_.max.y - bounds_.min.y;
  side_nm_ = std::max(reach_nm, std::max(width, depth) / kMostSquares + 1);
  const int64_t most = kSpareMembers + kMembersPerFacet * std::ssize(listed);
  const auto members = [&] {
    int64_t count = 0;
    for (const uint32_t i : listed) count += SquaresOf(facets_[i]).Count();
    return count;
  };
  while (members() > most) side_nm_ *= 2;
  columns_ = width / side_nm_ + 1;
  rows_ = depth / side_nm_ + 1;
}

void TopSurface::ListFacets(std::span<const uint32_t> listed) {
  const auto for_each_square = [&](uint32_t i, const auto& visit) {
    const auto [low, high] = SquaresOf(facets_[i]);
    for (int64_t row = low.row; row <= high.row; ++row)
      for (int64_t column = low.column; column <= high.column; ++column)
        visit(static_cast<size_t>(row * columns_ + column));
  };
  first_.assign(static_cast<size_t>(columns_ * rows_) + 1, 0);
  for (const uint32_t i : listed) for_each_square(i, [&](size_t square) { ++first_[square + 1]; });
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  members_.resize(first_.back());
  std::vector<uint32_t> next = first_;
  for (const uint32_t i : listed)
    for_each_square(i, [&](size_t square) { members_[next[square]++] = i; });
}

TopSurface::Squares TopSurface::SquaresOf(const SurfaceFacet& facet) const {
  const Box box = BoundsOf(facet);
  return {SquareOf(box.min), SquareOf(box.max)};
}

TopSurface::Square TopSurface::SquareOf(Point point) const {
  const auto index = [&](Coord from_least) {
    return from_least >= 0 ? from_least / side_nm_ : -1 - (-1 - from_least) / side_nm_;
  };
  return {index(point.x - bounds_.min.x), index(point.y - bounds_.min.y)};
}

std::span<const uint32_t> TopSurface::FacetsIn(Square square) const {
  if (square.column < 0 || square.column >= columns_ || square.row < 0 || square.row >= rows_)
    return {};
  const auto i = static_cast<size_t>(square.row * columns_ + square.column);
  return std::span(members_).subspan(first_[i], first_[i + 1] - first_[i]);
}

std::optional<SurfacePlace> TopSurface::At(Point point, double low_nm, double high_nm) const {
  std::optional<SurfacePlace> highest;
  if (members_.empty()) return highest;
  for (const uint32_t facet : FacetsIn(SquareOf(point))) {
    if (highest && static_cast<double>(HighestOf(facets_[facet])) <= highest->up_nm) break;
    const auto place = PlaceOn(facets_[facet], point);
    if (!place || place->up_nm < low_nm || place->up_nm > high_nm) continue;
    if (!highest || place->up_nm > highest->up_nm) highest = place;
  }
  return highest;
}

bool TopSurface::IsNear(Point point) const {
  if (members_.empty()) return false;
  const Square square = SquareOf(point);
  for (int64_t row = square.row - 1; row <= square.row + 1; ++row)
    for (int64_t column = square.column - 1; column <= square.column + 1; ++column)
      if (!FacetsIn({column, row}).empty()) return true;
  return false;
}

}  // namespace slicefarm::motion
