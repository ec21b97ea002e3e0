#include "services/texture/algo/pattern/section.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::texture {
namespace {

constexpr int32_t kMostCells = 2048;  // cells along a side

double Turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

/// Adds the relative position on the line from `a` to `b` that is closest to `p`, if it is on the
/// line.
void AddShareOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p,
                std::vector<double>* shares) {
  const Eigen::Vector2d path = b - a;
  const double share = (p - a).dot(path) / path.squaredNorm();
  if (share > 0 && share < 1) shares->push_back(share);
}

/// Returns the point of an edge at a height, with the same bits for both of its triangles.
Eigen::Vector2d MeetingPlace(const SurfaceMesh& mesh, int32_t i, int32_t k, double height) {
  const Eigen::Vector3d& a = mesh.points_mm[std::min(i, k)];
  const Eigen::Vector3d& b = mesh.points_mm[std::max(i, k)];
  const double share = (height - a.z()) / (b.z() - a.z());
  return a.head<2>() + share * (b - a).head<2>();
}

/// Returns the side that a triangle adds to a section. REQUIRES: it has vertices above and below.
OutlineSide SideAt(const SurfaceMesh& mesh, const std::array<int32_t, 3>& triangle, double height) {
  OutlineSide side;
  for (int k = 0; k < 3; ++k) {
    const int32_t a = triangle[k], b = triangle[(k + 1) % 3];
    const bool a_above = mesh.points_mm[a].z() >= height;
    const bool b_above = mesh.points_mm[b].z() >= height;
    if (a_above && !b_above) side.from = MeetingPlace(mesh, a, b, height);
    if (!a_above && b_above) side.to = MeetingPlace(mesh, a, b, height);
  }
  return side;
}

}  // namespace

Section::Section(std::vector<OutlineSide> sides, const Eigen::Vector2d& tile_mm)
    : sides_(std::move(sides)) {
  const auto side_cells = std::clamp(
      static_cast<int32_t>(std::sqrt(static_cast<double>(sides_.size()))), 1, kMostCells);
  counts_ = {side_cells, side_cells};
  cell_mm_ = tile_mm / side_cells;
  std::vector<std::pair<int32_t, int32_t>> places;  // cell and side
  for (size_t i = 0; i < sides_.size(); ++i) {
    const Eigen::Vector2d low = sides_[i].from.cwiseMin(sides_[i].to);
    const Eigen::Vector2d high = sides_[i].from.cwiseMax(sides_[i].to);
    for (int32_t row = CellOf(low.y(), 1); row <= CellOf(high.y(), 1); ++row)
      for (int32_t column = CellOf(low.x(), 0); column <= CellOf(high.x(), 0); ++column)
        places.emplace_back(row * counts_[0] + column, static_cast<int32_t>(i));
  }
  starts_.assign(static_cast<size_t>(counts_[0]) * counts_[1] + 1, 0);
  for (const auto& [cell, side] : places) ++starts_[cell + 1];
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  listed_.resize(places.size());
  std::vector<int32_t> next(starts_.begin(), starts_.end() - 1);
  for (const auto& [cell, side] : places) listed_[next[cell]++] = side;
}

int32_t Section::CellOf(double place, int axis) const {
  const double cell = place / cell_mm_[axis];
  return static_cast<int32_t>(std::clamp(cell, 0.0, counts_[axis] - 1.0));
}

std::span<const int32_t> Section::SidesIn(int32_t column, int32_t row) const {
  const size_t cell = static_cast<size_t>(row) * counts_[0] + column;
  return std::span(listed_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
}

double Section::AreaMm2() const {
  double doubled = 0;
  for (const OutlineSide& side : sides_)
    doubled += side.from.x() * side.to.y() - side.from.y() * side.to.x();
  return doubled / 2;
}

bool Section::Contains(const Eigen::Vector2d& place_mm) const {
  int winding = 0;  // winding number along the ray in x
  const int32_t row = CellOf(place_mm.y(), 1);
  for (int32_t column = CellOf(place_mm.x(), 0); column < counts_[0]; ++column) {
    for (const int32_t i : SidesIn(column, row)) {
      const auto& [from, to] = sides_[i];
      const bool from_above = from.y() > place_mm.y(), to_above = to.y() > place_mm.y();
      if (from_above == to_above) continue;
      const double share = (place_mm.y() - from.y()) / (to.y() - from.y());
      const auto [least, most] = std::minmax(from.x(), to.x());
      const double x = std::clamp(from.x() + share * (to.x() - from.x()), least, most);
      // A side may be listed in several cells. It counts only in the cell that contains its
      // crossing with the ray.
      if (x > place_mm.x() && CellOf(x, 0) == column) winding += to_above ? 1 : -1;
    }
  }
  return winding != 0;
}

void Section::Crossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        std::vector<double>* shares) const {
  // Cells that the line only touches are tested too. At a corner, rounding may assign the crossing
  // to either of the corner's sides.
  const Eigen::Vector2d slack = 1e-9 * cell_mm_;
  const double on_way = slack.minCoeff() * (b - a).norm();
  const Eigen::Vector2d low = a.cwiseMin(b) - slack, high = a.cwiseMax(b) + slack;
  for (int32_t row = CellOf(low.y(), 1); row <= CellOf(high.y(), 1); ++row) {
    // Range of the line within this row of cells.
    double left = low.x(), right = high.x();
    if (a.y() != b.y()) {
      const auto at = [&](double y) {
        return a.x() + (b.x() - a.x()) * std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0);
      };
      const double x0 = at(row * cell_mm_.y() - slack.y());
      const double x1 = at((row + 1) * cell_mm_.y() + slack.y());
      left = std::min(x0, x1) - slack.x();
      right = std::max(x0, x1) + slack.x();
    }
    for (int32_t column = CellOf(left, 0); column <= CellOf(right, 0); ++column) {
      for (const int32_t i : SidesIn(column, row)) {
        const auto& [from, to] = sides_[i];
        const double turn_from = Turn(a, b, from), turn_to = Turn(a, b, to);
        // If the line is along a side, all points of the side are crossings. The ends of the side
        // are added.
        if (std::abs(turn_from) <= on_way) AddShareOf(a, b, from, shares);
        if (std::abs(turn_to) <= on_way) AddShareOf(a, b, to, shares);
        if ((turn_from >= 0) == (turn_to >= 0)) continue;
        const double da = Turn(from, to, a), db = Turn(from, to, b);
        if ((da >= 0) != (db >= 0)) shares->push_back(da / (da - db));
      }
    }
  }
}

std::vector<Section> SectionsOf(const Texture& texture, std::span<const double> heights_mm) {
  const SurfaceMesh& mesh = texture.solid;
  std::vector<std::vector<OutlineSide>> sides(heights_mm.size());
  for (const auto& triangle : mesh.triangles) {
    const auto [low, high] =
        std::minmax({mesh.points_mm[triangle[0]].z(), mesh.points_mm[triangle[1]].z(),
                     mesh.points_mm[triangle[2]].z()});
    const auto first = std::upper_bound(heights_mm.begin(), heights_mm.end(), low);
    for (auto height = first; height != heights_mm.end() && *height <= high; ++height)
      sides[height - heights_mm.begin()].push_back(SideAt(mesh, triangle, *height));
  }
  std::vector<Section> sections;
  for (std::vector<OutlineSide>& of_height : sides)
    sections.emplace_back(std::move(of_height), texture.tile_mm);
  return sections;
}

}  // namespace slicefarm::texture
