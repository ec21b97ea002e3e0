#include "services/planning/algo/infill/cubic_octree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>

namespace slicefarm::planning {
namespace {

// A cube's edges against the plane: each normal has this much along the layer and across it.
const double kAlong = std::sqrt(2.0 / 3.0);
const double kAcross = std::sqrt(1.0 / 3.0);
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;
/// Points are looked at on a grid of this share of the planes' distance.
constexpr double kStepShare = 0.5;

}  // namespace

size_t CubicOctree::CellHash::operator()(const Cell& cell) const {
  uint64_t hash = 0;
  for (const int32_t i : cell) hash = (hash ^ static_cast<uint32_t>(i)) * 0x9E3779B97F4A7C15ULL;
  return static_cast<size_t>(hash ^ (hash >> 32));
}

CubicOctree::CubicOctree(double pitch_nm, double angle_rad, double reach_nm)
    : distance_(3 * kAlong * pitch_nm),
      reach_(reach_nm),
      step_(kStepShare * distance_),
      frames_{LineAxes(angle_rad), LineAxes(angle_rad + kThirdTurn),
              LineAxes(angle_rad + 2 * kThirdTurn)} {
  // No coordinate along a normal is greater than this.
  const double farthest = std::sqrt(3.0) * reach_nm;
  double half = 2 * distance_;
  for (levels_ = 1; half < farthest; ++levels_) half *= 2;
  divided_.resize(static_cast<size_t>(levels_));
}

double CubicOctree::EdgeOf(int level) const {
  return 2 * distance_ * static_cast<double>(int64_t{1} << (levels_ - level));
}

bool CubicOctree::Exists(int level, const Cell& cell) const {
  if (level <= 1) return true;
  const Cell parent{cell[0] >> 1, cell[1] >> 1, cell[2] >> 1};
  return divided_[static_cast<size_t>(level - 1)].contains(parent);
}

void CubicOctree::Add(Point place, Coord z_nm) {
  std::array<double, 3> along;
  for (int family = 0; family < 3; ++family)
    along[static_cast<size_t>(family)] =
        kAlong * FrameOf(family).V(place) - kAcross * static_cast<double>(z_nm);
  const auto cell_of = [&](double edge) {
    Cell cell;
    for (size_t i = 0; i < 3; ++i) cell[i] = static_cast<int32_t>(std::floor(along[i] / edge));
    return cell;
  };
  if (!seen_.insert(cell_of(step_)).second) return;
  for (int level = 1; level < levels_; ++level) {
    const double edge = EdgeOf(level);
    // What stands for all points of a step may be off by the step's diagonal.
    const double ball = std::sqrt(3.0) * (edge / 2 + step_);
    const Cell middle = cell_of(edge);
    for (int32_t k = 0; k < 27; ++k) {
      const Cell cell{middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1};
      double square = 0;
      for (size_t i = 0; i < 3; ++i) {
        const double away = (static_cast<double>(cell[i]) + 0.5) * edge - along[i];
        square += away * away;
      }
      if (square <= ball * ball) divided_[static_cast<size_t>(level)].insert(cell);
    }
  }
}

void CubicOctree::AddLine(int family, int64_t plane, double z_nm,
                          std::vector<Polyline>& lines) const {
  // Planes whose number has more factors of two belong to greater cubes.
  const int level =
      plane == 0 ? 0 : std::max(0, levels_ - std::countr_zero(static_cast<uint64_t>(plane)));
  const double edge = EdgeOf(level);
  const double v = (static_cast<double>(plane) * distance_ + kAcross * z_nm) / kAlong;
  if (std::abs(v) >= reach_) return;
  const double half = std::sqrt(reach_ * reach_ - v * v);
  // At u along the line the other two numbers are mean - u / sqrt 2 and mean + u / sqrt 2.
  const double mean = -(std::sqrt(3.0) * z_nm + static_cast<double>(plane) * distance_) / 2;
  std::vector<double> cuts = {-half, half};
  if (level > 1) {
    for (const double side : {-1.0, 1.0}) {
      const double span = half / std::numbers::sqrt2;
      const auto first = static_cast<int64_t>(std::ceil((mean - span) / edge));
      const auto last = static_cast<int64_t>(std::floor((mean + span) / edge));
      for (int64_t i = first; i <= last; ++i)
        cuts.push_back(side * (static_cast<double>(i) * edge - mean) * std::numbers::sqrt2);
    }
    std::ranges::sort(cuts);
  }
  const auto exists_at = [&](double u) {
    const double aside = u / std::numbers::sqrt2;
    const auto index = [&](double along) { return static_cast<int32_t>(std::floor(along / edge)); };
    Cell cell;
    cell[static_cast<size_t>(family)] = index(static_cast<double>(plane) * distance_);
    cell[static_cast<size_t>((family + 1) % 3)] = index(mean - aside);
    cell[static_cast<size_t>((family + 2) % 3)] = index(mean + aside);
    return Exists(level, cell);
  };
  for (size_t i = 0; i + 1 < cuts.size();) {
    if (cuts[i + 1] <= cuts[i] || !exists_at((cuts[i] + cuts[i + 1]) / 2)) {
      ++i;
      continue;
    }
    const double from = cuts[i];
    while (i + 1 < cuts.size() &&
           (cuts[i + 1] <= cuts[i] || exists_at((cuts[i] + cuts[i + 1]) / 2)))
      ++i;
    const Point a = FrameOf(family).At(from, v), b = FrameOf(family).At(cuts[i], v);
    if (a != b) lines.push_back({a, b});
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
