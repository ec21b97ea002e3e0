#include "services/planning/algo/infill/cubic_octree.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace slicefarm::planning {
namespace {

using Cell = CubicOctree::Cell;
using Cells = CubicOctree::Cells;
using Shares = CubicOctree::Shares;

// Components of a plane's unit normal in the plane of the layer and perpendicular to the layer, for
// a cube that stands on a corner.
const double kAlong = std::sqrt(2.0 / 3.0);
const double kAcross = std::sqrt(1.0 / 3.0);
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;

/// Returns the cube of double size that contains `cell`. `by`: offset (0 or 1 per axis) at which
/// eight cubes are grouped into a larger one.
Cell DoubledCell(const Cell& cell, const Cell& by) {
  return {(cell[0] + by[0]) >> 1, (cell[1] + by[1]) >> 1, (cell[2] + by[2]) >> 1};
}

Cells Doubled(const Cells& cubes, const Cell& by) {
  Cells doubled;
  for (const Cell& cell : cubes) doubled.insert(DoubledCell(cell, by));
  return doubled;
}

Shares Doubled(const Shares& body, const Cell& by) {
  Shares doubled;
  for (const auto& [cell, share] : body) doubled[DoubledCell(cell, by)] += share;
  return doubled;
}

/// Returns the offset for which the doubled cubes contain the fewest samples of the body. Of equal
/// offsets, the one with the fewest cubes is returned, then the first.
Cell LeastFilled(const Cells& cubes, const Shares& body) {
  std::pair<int64_t, size_t> least;
  Cell best{};
  for (int32_t path = 0; path < 8; ++path) {
    const Cell by{path & 1, path >> 1 & 1, path >> 2};
    const Cells doubled = Doubled(cubes, by);
    std::pair<int64_t, size_t> found{0, doubled.size()};
    for (const auto& [cell, share] : body)
      if (doubled.contains(DoubledCell(cell, by))) found.first += share;
    if (path == 0 || found < least) {
      least = found;
      best = by;
    }
  }
  return best;
}

}  // namespace

size_t CubicOctree::CellHash::operator()(const Cell& cell) const {
  uint64_t hash = 0;
  for (const int32_t i : cell) hash = (hash ^ static_cast<uint32_t>(i)) * 0x9E3779B97F4A7C15ULL;
  return static_cast<size_t>(hash ^ (hash >> 32));
}

CubicOctree::CubicOctree(double pitch_nm, double angle_rad, double reach_nm)
    : distance_(3 * kAlong * pitch_nm),
      reach_(reach_nm),
      frames_{LineAxes(angle_rad), LineAxes(angle_rad + kThirdTurn),
              LineAxes(angle_rad + 2 * kThirdTurn)} {}

double CubicOctree::EdgeOf(size_t level) const {
  return 2 * distance_ * static_cast<double>(int64_t{1} << level);
}

std::array<double, 3> CubicOctree::AlongOf(Point point, Coord z_nm) const {
  std::array<double, 3> along;
  for (size_t i = 0; i < 3; ++i)
    along[i] = (kAlong * frames_[i].V(point) - kAcross * static_cast<double>(z_nm)) / distance_;
  return along;
}

void CubicOctree::Add(Point point, Coord z_nm, double around_nm) {
  const double around = kAlong * around_nm / distance_;
  Cell first, last;
  const auto along = AlongOf(point, z_nm);
  for (size_t i = 0; i < 3; ++i) {
    first[i] = static_cast<int32_t>(std::floor(along[i] - around));
    last[i] = static_cast<int32_t>(std::floor(along[i] + around));
  }
  for (Cell cell{first[0]}; cell[0] <= last[0]; ++cell[0])
    for (cell[1] = first[1]; cell[1] <= last[1]; ++cell[1])
      for (cell[2] = first[2]; cell[2] <= last[2]; ++cell[2]) places_.insert(cell);
}

void CubicOctree::AddBody(Point point, Coord z_nm) {
  const auto along = AlongOf(point, z_nm);
  ++body_[{static_cast<int32_t>(std::floor(along[0])), static_cast<int32_t>(std::floor(along[1])),
           static_cast<int32_t>(std::floor(along[2]))}];
}

void CubicOctree::Grow() {
  // Largest coordinate of any point along a normal.
  const double farthest = std::sqrt(3.0) * reach_;
  Cells cubes = std::move(places_);
  Shares body = std::move(body_);
  Cell shift{};
  for (size_t level = 0; EdgeOf(level) < 2 * farthest; ++level) {
    const Cell by = LeastFilled(cubes, body);
    for (size_t i = 0; i < 3; ++i) shift[i] += by[i] * (int32_t{1} << level);
    cubes = Doubled(cubes, by);
    body = Doubled(body, by);
    levels_.push_back({cubes, shift});
  }
}

size_t CubicOctree::LevelOf(int family, int64_t plane) const {
  const auto axis = static_cast<size_t>(family);
  size_t level = 0;
  while (level < levels_.size() && ((plane + levels_[level].shift[axis]) >> level) % 2 == 0)
    ++level;
  return level;
}

std::vector<double> CubicOctree::CutsOf(size_t level, int family, double mean, double half) const {
  std::vector<double> cuts = {-half, half};
  const double edge = EdgeOf(level), span = half / std::numbers::sqrt2;
  double side = -1;
  for (const int other : {family + 1, family + 2}) {
    const double shift = distance_ * levels_[level].shift[static_cast<size_t>(other % 3)];
    const auto first = static_cast<int64_t>(std::ceil((mean - span + shift) / edge));
    const auto last = static_cast<int64_t>(std::floor((mean + span + shift) / edge));
    for (int64_t i = first; i <= last; ++i)
      cuts.push_back(side * (static_cast<double>(i) * edge - shift - mean) * std::numbers::sqrt2);
    side = 1;
  }
  std::ranges::sort(cuts);
  return cuts;
}

void CubicOctree::AddLine(int family, int64_t plane, double z_nm,
                          std::vector<Polyline>& lines) const {
  const size_t level = LevelOf(family, plane);
  const double v = (static_cast<double>(plane) * distance_ + kAcross * z_nm) / kAlong;
  if (std::abs(v) >= reach_) return;
  const double half = std::sqrt(reach_ * reach_ - v * v);
  const auto add = [&](double from, double to) {
    const Point a = FrameOf(family).At(from, v), b = FrameOf(family).At(to, v);
    if (a != b) lines.push_back({a, b});
  };
  if (level == levels_.size()) return add(-half, half);
  // At position u along the line, the coordinates along the two other normals are mean - u / sqrt 2
  // and mean + u / sqrt 2.
  const double mean = -(std::sqrt(3.0) * z_nm + static_cast<double>(plane) * distance_) / 2;
  const Level& of = levels_[level];
  const auto exists_at = [&](double u) {
    const double aside = u / std::numbers::sqrt2;
    const std::array<double, 3> along = {static_cast<double>(plane) * distance_, mean - aside,
                                         mean + aside};
    Cell cell;
    for (size_t k = 0; k < 3; ++k) {
      const size_t axis = (static_cast<size_t>(family) + k) % 3;
      cell[axis] =
          static_cast<int32_t>(std::floor((along[k] + distance_ * of.shift[axis]) / EdgeOf(level)));
    }
    return of.cubes.contains(cell);
  };
  const std::vector<double> cuts = CutsOf(level, family, mean, half);
  for (size_t i = 0; i + 1 < cuts.size();) {
    const double from = cuts[i];
    bool exists = false;
    for (; i + 1 < cuts.size(); ++i) {
      if (cuts[i + 1] <= cuts[i]) continue;
      if (!exists_at((cuts[i] + cuts[i + 1]) / 2)) break;
      exists = true;
    }
    if (exists) add(from, cuts[i]);
    if (!exists || i + 1 < cuts.size()) ++i;
  }
}

std::vector<Polyline> CubicOctree::LinesAt(double z_nm) const {
  std::vector<Polyline> lines;
  const auto number = [&](double v) { return (kAlong * v - kAcross * z_nm) / distance_; };
  for (int family = 0; family < 3; ++family) {
    const auto first = static_cast<int64_t>(std::ceil(number(-reach_)));
    const auto last = static_cast<int64_t>(std::floor(number(reach_)));
    for (int64_t plane = first; plane <= last; ++plane) AddLine(family, plane, z_nm, lines);
  }
  return lines;
}

}  // namespace slicefarm::planning
