#include "services/texture/algo/paths/line_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/sparse_cholesky.h"

namespace slicefarm::texture {
namespace {

constexpr int kRoundsOfSquares = 10;  // then the sum of errors instead of squares
constexpr int kMostRounds = 400;
constexpr double kSlack = 0.05;  // accepted deviation of gradient lengths from 1
constexpr double kShrink = 0.3;  // share of a gradient's error forgiven per round
// The iteration ends when at least the share kEnough of the lines' length has a distance within the
// fraction kEven of the requested distance.
constexpr double kEven = 0.1;
constexpr double kEnough = 0.96;

/// Gradients of a triangle's hat functions, laid flat, and its area.
struct FlatHats {
  std::array<Eigen::Vector2d, 3> gradients;
  double area = 0;
};

FlatHats HatsOf(const SurfaceMesh& mesh, size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const RestTriangle rest = RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
  const Eigen::Vector2d first = rest.inverse_edges.row(0), second = rest.inverse_edges.row(1);
  return {{-first - second, first, second}, rest.area};
}

Eigen::Vector2d GradientOf(const FlatHats& hats, const std::array<int32_t, 3>& corners,
                           const std::vector<double>& field) {
  return field[corners[0]] * hats.gradients[0] + field[corners[1]] * hats.gradients[1] +
         field[corners[2]] * hats.gradients[2];
}

/// Returns `v` with its length moved towards the nearest acceptable length. The result's error is
/// the error of `v` minus `forgiven`, at least 0.
Eigen::Vector2d NearestFair(const Eigen::Vector2d& v, double forgiven) {
  const double length = v.norm();
  if (length == 0) return v;
  const double fair = std::clamp(length, 1 - kSlack, 1 + kSlack), off = length - fair;
  const double kept = forgiven == 0 ? 0 : std::max(std::abs(off) - forgiven, 0.0);
  return v / length * (fair + std::copysign(kept, off));
}

/// Finds fields from their gradients, by least squares over the surface.
class GradientFit {
 public:
  explicit GradientFit(const SurfaceMesh& mesh) : mesh_(mesh), system_(SystemOf(mesh)) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t) hats_.push_back(HatsOf(mesh, t));
  }

  const std::vector<FlatHats>& hats() const { return hats_; }

  absl::Status Factor() {
    const auto values = system_.values();
    std::fill(values.begin(), values.end(), 0.0);
    std::vector<bool> used(mesh_.points_mm.size(), false);
    for (size_t t = 0; t < hats_.size(); ++t) {
      const auto& corners = mesh_.triangles[t];
      for (int i = 0; i < 3; ++i) {
        used[corners[i]] = true;
        for (int k = 0; k < 3; ++k) {
          if (corners[i] < corners[k]) continue;
          values[system_.IndexOf(corners[i], corners[k])] +=
              hats_[t].area * hats_[t].gradients[i].dot(hats_[t].gradients[k]);
        }
      }
    }
    // A constant may be added to a field, so one of its values is fixed.
    values[system_.IndexOf(mesh_.triangles[0][0], mesh_.triangles[0][0])] += 1;
    for (size_t v = 0; v < used.size(); ++v) {
      const auto vertex = static_cast<int32_t>(v);
      if (!used[v]) values[system_.IndexOf(vertex, vertex)] = 1;
    }
    return system_.Factor();
  }

  std::vector<double> FieldOf(const std::vector<Eigen::Vector2d>& gradients) const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<int64_t>(mesh_.points_mm.size()));
    for (size_t t = 0; t < hats_.size(); ++t)
      for (int k = 0; k < 3; ++k)
        right[mesh_.triangles[t][k]] += hats_[t].area * hats_[t].gradients[k].dot(gradients[t]);
    const Eigen::VectorXd field = system_.Solve(right);
    return {field.begin(), field.end()};
  }

 private:
  static SparseCholesky SystemOf(const SurfaceMesh& mesh) {
    std::vector<SparseCholesky::BlockIndex> indices;
    for (const auto& corners : mesh.triangles)
      for (int k = 0; k < 3; ++k) indices.emplace_back(corners[k], corners[(k + 1) % 3]);
    return {static_cast<int32_t>(mesh.points_mm.size()), indices};
  }

  const SurfaceMesh& mesh_;
  SparseCholesky system_;
  std::vector<FlatHats> hats_;
};

}  // namespace

std::vector<double> StraightField(const SurfaceMap& map, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d across(-direction.y(), direction.x());
  std::vector<double> field;
  field.reserve(map.map_mm().size());
  for (const Eigen::Vector2d& p : map.map_mm()) field.push_back(across.dot(p));
  return field;
}

absl::StatusOr<std::vector<double>> EquidistantField(const SurfaceMap& map,
                                                     const Eigen::Vector2d& direction,
                                                     const CancelToken& cancel) {
  GradientFit fit(map.mesh());
  if (const absl::Status status = fit.Factor(); !status.ok()) return status;
  std::vector<double> field = StraightField(map, direction);
  std::vector<Eigen::Vector2d> wanted(fit.hats().size(), Eigen::Vector2d::Zero());
  std::vector<Eigen::Vector2d> rest = wanted;
  std::vector<double> best;
  double best_share = -1;
  for (int round = 0; round < kMostRounds; ++round) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    double length = 0, even_length = 0;  // length of the levels
    for (size_t t = 0; t < wanted.size(); ++t) {
      const Eigen::Vector2d gradient = GradientOf(fit.hats()[t], map.mesh().triangles[t], field);
      const double levels = fit.hats()[t].area * gradient.norm();
      length += levels;
      if (std::abs(1 / gradient.norm() - 1) <= kEven) even_length += levels;
      if (round < kRoundsOfSquares) {
        wanted[t] = NearestFair(gradient, 0);
        continue;
      }
      const Eigen::Vector2d sum = gradient + rest[t];
      const Eigen::Vector2d near = NearestFair(sum, kShrink);
      rest[t] = sum - near;
      wanted[t] = near - rest[t];
    }
    const double share = length > 0 ? even_length / length : 0;
    if (share > best_share) best_share = share, best = field;
    if (share >= kEnough) break;
    field = fit.FieldOf(wanted);
  }
  return best;
}

double GradientLength(const SurfaceMap& map, const std::vector<double>& field, int32_t triangle) {
  return GradientOf(HatsOf(map.mesh(), triangle), map.mesh().triangles[triangle], field).norm();
}

std::vector<double> CentredLevels(double low, double high, double spacing) {
  const double length = high - low;
  const auto count = std::max<int64_t>(1, static_cast<int64_t>(std::floor(length / spacing)));
  std::vector<double> levels;
  levels.reserve(count);
  for (int64_t i = 0; i < count; ++i)
    levels.push_back(low + (length - static_cast<double>(count - 1) * spacing) / 2 +
                     static_cast<double>(i) * spacing);
  return levels;
}

}  // namespace slicefarm::texture
