#include "services/texture/algo/map/tutte.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"
#include "services/texture/algo/map/sparse_cholesky.h"

namespace slicefarm::texture {
namespace {

constexpr int kRounds = 2;  // more rounds shrink other places again

struct Spring {
  int32_t a = 0;
  int32_t b = 0;
  double length_mm = 0;  ///< length on the surface
  double weight = 1;
};

/// Returns a spring for each edge of the surface, and for each hole the springs from an additional
/// vertex in its centre to the hole's loop.
std::vector<Spring> SpringsOf(const SurfaceMesh& mesh, std::span<const BoundaryLoop> loops) {
  std::vector<std::pair<int32_t, int32_t>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax(triangle[k], triangle[(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<Spring> springs;
  for (const auto& [a, b] : edges)
    springs.push_back({a, b, (mesh.points_mm[a] - mesh.points_mm[b]).norm()});
  for (size_t hole = 1; hole < loops.size(); ++hole) {
    const auto middle = static_cast<int32_t>(mesh.points_mm.size() + hole - 1);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int32_t vertex : loops[hole]) centre += mesh.points_mm[vertex];
    centre /= static_cast<double>(loops[hole].size());
    for (const int32_t vertex : loops[hole])
      springs.push_back({vertex, middle, (mesh.points_mm[vertex] - centre).norm()});
  }
  return springs;
}

double AreaOf(const SurfaceMesh& mesh) {
  double area = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) area += DoubleAreaVector(mesh, t).norm() / 2;
  return area;
}

/// Puts the outer loop's vertices on the circle.
void PinLoop(const SurfaceMesh& mesh, const BoundaryLoop& loop,
             std::vector<Eigen::Vector2d>* points) {
  std::vector<double> along = {0};
  for (size_t i = 0; i < loop.size(); ++i)
    along.push_back(along.back() +
                    (mesh.points_mm[loop[(i + 1) % loop.size()]] - mesh.points_mm[loop[i]]).norm());
  const double radius = std::sqrt(AreaOf(mesh) / std::numbers::pi);
  for (size_t i = 0; i < loop.size(); ++i) {
    const double angle = 2 * std::numbers::pi * along[i] / along.back();
    (*points)[loop[i]] = radius * Eigen::Vector2d(Cos(angle), Sin(angle));
  }
}

/// Net of springs that determines the positions of vertices between pinned ones.
class SpringNet {
 public:
  SpringNet(std::vector<Spring> springs, const BoundaryLoop& pinned, size_t vertices)
      : springs_(std::move(springs)), row_(vertices, kUnused) {
    for (const Spring& spring : springs_) row_[spring.a] = row_[spring.b] = 0;
    for (const int32_t vertex : pinned) row_[vertex] = kPinned;
    for (int32_t& row : row_) {
      if (row == 0) row = rows_++;
    }
    std::vector<SparseCholesky::BlockIndex> indices;
    for (const Spring& spring : springs_) {
      if (row_[spring.a] >= 0 && row_[spring.b] >= 0)
        indices.emplace_back(row_[spring.a], row_[spring.b]);
    }
    system_ = std::make_unique<SparseCholesky>(rows_, indices);
  }

  /// Weakens a spring if its edge in the map is shorter than its length on the surface requires,
  /// and strengthens it if the edge is longer.
  void Balance(const std::vector<Eigen::Vector2d>& points) {
    for (Spring& spring : springs_) {
      const double ratio = (points[spring.a] - points[spring.b]).norm() / spring.length_mm;
      spring.weight = std::clamp(spring.weight * ratio, 1e-12, 1e12);
    }
  }

  absl::Status Solve(std::vector<Eigen::Vector2d>* points) {
    if (rows_ == 0) return absl::OkStatus();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(rows_), y = Eigen::VectorXd::Zero(rows_);
    std::fill(system_->values().begin(), system_->values().end(), 0);
    for (const Spring& spring : springs_) {
      Add(spring.a, spring.b, spring.weight, *points, &x, &y);
      Add(spring.b, spring.a, spring.weight, *points, &x, &y);
    }
    if (absl::Status status = system_->Factor(); !status.ok()) return status;
    x = system_->Solve(x);
    y = system_->Solve(y);
    for (size_t i = 0; i < row_.size(); ++i) {
      if (row_[i] >= 0) (*points)[i] = {x[row_[i]], y[row_[i]]};
    }
    return absl::OkStatus();
  }

 private:
  static constexpr int32_t kPinned = -1, kUnused = -2;

  /// Adds the pull of `other` on `vertex`.
  void Add(int32_t vertex, int32_t other, double weight, const std::vector<Eigen::Vector2d>& points,
           Eigen::VectorXd* x, Eigen::VectorXd* y) {
    const int32_t row = row_[vertex];
    if (row < 0) return;
    system_->values()[system_->IndexOf(row, row)] += weight;
    if (const int32_t column = row_[other]; column < 0) {
      (*x)[row] += weight * points[other].x();
      (*y)[row] += weight * points[other].y();
    } else if (row > column) {
      system_->values()[system_->IndexOf(row, column)] -= weight;
    }
  }

  std::vector<Spring> springs_;
  std::vector<int32_t> row_;
  int32_t rows_ = 0;
  std::unique_ptr<SparseCholesky> system_;
};

}  // namespace

absl::StatusOr<FirstMap> TutteEmbedding(const SurfaceMesh& mesh,
                                        std::span<const BoundaryLoop> loops) {
  const size_t vertices = mesh.points_mm.size() + loops.size() - 1;
  std::vector<Eigen::Vector2d> points(vertices, Eigen::Vector2d::Zero());
  PinLoop(mesh, loops[0], &points);
  SpringNet net(SpringsOf(mesh, loops), loops[0], vertices);
  if (absl::Status status = net.Solve(&points); !status.ok()) return status;
  for (int i = 0; i < kRounds; ++i) {
    net.Balance(points);
    if (absl::Status status = net.Solve(&points); !status.ok()) return status;
  }
  FirstMap map;
  const auto holes = points.begin() + static_cast<std::ptrdiff_t>(mesh.points_mm.size());
  map.points.assign(points.begin(), holes);
  map.hole_middles.assign(holes, points.end());
  return map;
}

}  // namespace slicefarm::texture
