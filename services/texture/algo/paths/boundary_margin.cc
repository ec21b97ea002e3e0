#include "services/texture/algo/paths/boundary_margin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::texture {
namespace {

constexpr double kMostMarginCells = 512;  // cells along a side

double SquaredDistance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b) {
  const Eigen::Vector2d path = b - a;
  const double share = std::clamp((p - a).dot(path) / path.squaredNorm(), 0.0, 1.0);
  return (p - a - share * path).squaredNorm();
}

void AddShare(double share, std::vector<double>* shares) {
  if (share > 0 && share < 1) shares->push_back(share);
}

/// Adds the positions where the line from `a` along `path` meets the circle around `centre`.
void AddCircle(const Eigen::Vector2d& a, const Eigen::Vector2d& path, const Eigen::Vector2d& centre,
               double radius, std::vector<double>* shares) {
  const Eigen::Vector2d to = a - centre;
  const double square = path.squaredNorm(), half = to.dot(path);
  const double root = half * half - square * (to.squaredNorm() - radius * radius);
  if (!(root > 0)) return;
  AddShare((-half - std::sqrt(root)) / square, shares);
  AddShare((-half + std::sqrt(root)) / square, shares);
}

/// Adds the relative positions where the line meets the two lines parallel to a side at distance
/// `radius`.
void AddBeside(const Eigen::Vector2d& a, const Eigen::Vector2d& path, const Eigen::Vector2d& from,
               const Eigen::Vector2d& to, double radius, std::vector<double>* shares) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const double speed = across.dot(path);
  if (speed == 0) return;
  for (const double side : {-radius, radius})
    AddShare((side - across.dot(a - from)) / speed, shares);
}

}  // namespace

BoundaryMargin::BoundaryMargin(const SurfaceMap& map, double margin_mm)
    : margin_mm_(margin_mm), low_mm_(map.low_mm()) {
  const Eigen::Vector2d size = map.high_mm() - map.low_mm();
  cell_mm_ = std::max(margin_mm, size.maxCoeff() / kMostMarginCells);
  for (const int axis : {0, 1})
    counts_[axis] = static_cast<int32_t>(std::floor(size[axis] / cell_mm_)) + 1;
  for (const auto& loop : map.loops())
    for (size_t i = 0; i < loop.size(); ++i)
      sides_.push_back({map.map_mm()[loop[i]], map.map_mm()[loop[(i + 1) % loop.size()]]});
  std::vector<std::pair<int32_t, int32_t>> places;  // cell and side
  const Eigen::Vector2d reach(margin_mm, margin_mm);
  for (size_t i = 0; i < sides_.size(); ++i) {
    const auto [from, to] = sides_[i];
    const auto low = CellOf(from.cwiseMin(to) - reach), high = CellOf(from.cwiseMax(to) + reach);
    for (int32_t row = low[1]; row <= high[1]; ++row)
      for (int32_t column = low[0]; column <= high[0]; ++column)
        places.emplace_back(row * counts_[0] + column, static_cast<int32_t>(i));
  }
  std::sort(places.begin(), places.end());
  starts_.assign(static_cast<size_t>(counts_[0]) * counts_[1] + 1, 0);
  for (const auto& [cell, side] : places) {
    ++starts_[cell + 1];
    listed_.push_back(side);
  }
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
}

std::array<int32_t, 2> BoundaryMargin::CellOf(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d cell = (place - low_mm_) / cell_mm_;
  return {static_cast<int32_t>(std::clamp(cell.x(), 0.0, counts_[0] - 1.0)),
          static_cast<int32_t>(std::clamp(cell.y(), 0.0, counts_[1] - 1.0))};
}

std::span<const int32_t> BoundaryMargin::SidesIn(int32_t column, int32_t row) const {
  const size_t cell = static_cast<size_t>(row) * counts_[0] + column;
  return std::span(listed_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
}

bool BoundaryMargin::Contains(const Eigen::Vector2d& map_mm) const {
  const auto [column, row] = CellOf(map_mm);
  for (const int32_t i : SidesIn(column, row))
    if (SquaredDistance(map_mm, sides_[i].from, sides_[i].to) < margin_mm_ * margin_mm_)
      return false;
  return true;
}

void BoundaryMargin::Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                          std::vector<double>* shares) const {
  const auto low = CellOf(a.cwiseMin(b)), high = CellOf(a.cwiseMax(b));
  const Eigen::Vector2d path = b - a;
  if (path.squaredNorm() == 0) return;
  std::vector<int32_t> near;
  for (int32_t row = low[1]; row <= high[1]; ++row)
    for (int32_t column = low[0]; column <= high[0]; ++column)
      near.insert(near.end(), SidesIn(column, row).begin(), SidesIn(column, row).end());
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const int32_t i : near) {
    AddCircle(a, path, sides_[i].from, margin_mm_, shares);
    AddBeside(a, path, sides_[i].from, sides_[i].to, margin_mm_, shares);
  }
}

}  // namespace slicefarm::texture
