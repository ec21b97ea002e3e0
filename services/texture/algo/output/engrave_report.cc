#include "services/texture/algo/output/engrave_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "services/texture/algo/map/distortion.h"

namespace slicefarm::texture {
namespace {

constexpr double kEvenShare = 0.1;

/// Returns the singular values of a map's Jacobian, the larger one first. Source: closed form for 2
/// x 2 matrices.
std::array<double, 2> StretchesOf(const Eigen::Matrix2d& j) {
  const Eigen::Vector2d turned(j(0, 0) + j(1, 1), j(1, 0) - j(0, 1));
  const Eigen::Vector2d mirrored(j(0, 0) - j(1, 1), j(1, 0) + j(0, 1));
  return {(turned.norm() + mirrored.norm()) / 2, std::abs(turned.norm() - mirrored.norm()) / 2};
}

}  // namespace

Spread SpreadOf(const std::vector<double>& values, const std::vector<double>& weights) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return values[a] < values[b]; });
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto at = [&](double share) {
    double below = 0;
    for (const size_t i : order) {
      below += weights[i];
      if (below >= share * all) return values[i];
    }
    return values[order.back()];
  };
  return {at(0.01), at(0.5), at(0.99)};
}

absl::StatusOr<MapReport> MapReportOf(const EngravePlan& plan, const CancelToken& cancel) {
  const auto distances = LineDistances(plan, cancel);
  if (!distances.ok()) return distances.status();
  const SurfaceMesh& mesh = plan.map.mesh();
  const double spacing = plan.options.lines[0].spacing_mm;
  MapReport report{.faces = static_cast<int64_t>(mesh.triangles.size())};
  std::vector<double> areas, stretches, stretch_weights;
  double lines = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const RestTriangle rest = RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
    const Eigen::Matrix2d jacobian =
        JacobianOf(rest, plan.map.map_mm()[a], plan.map.map_mm()[b], plan.map.map_mm()[c]);
    const double energy = SymmetricDirichlet(jacobian) / 4;
    report.area_mm2 += rest.area;
    report.energy_mean += rest.area * energy;
    report.energy_max = std::max(report.energy_max, energy);
    areas.push_back(rest.area);
    for (const double stretch : StretchesOf(jacobian)) {
      stretches.push_back(stretch);
      stretch_weights.push_back(rest.area);
    }
    lines += rest.area / (*distances)[t];
    if (std::abs((*distances)[t] / spacing - 1) <= kEvenShare)
      report.line_even += rest.area / (*distances)[t];
  }
  report.energy_mean /= report.area_mm2;
  report.line_even /= lines;
  report.stretch = SpreadOf(stretches, stretch_weights);
  report.line_distance_mm = SpreadOf(*distances, areas);
  return report;
}

LayerNumbers NumbersOf(const LayerPath& path) {
  return {path.layer,      path.height_mm, path.offset_mm,
          path.spacing_mm, path.runs,      static_cast<int64_t>(path.points.size()),
          path.on_mm,      path.off_mm,    path.section_mm2,
          path.folds,      path.folds_mm,  path.first_fold_mm};
}

}  // namespace slicefarm::texture
