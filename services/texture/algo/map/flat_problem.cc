#include "services/texture/algo/map/flat_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/vector.h"
#include "services/texture/algo/map/exact_turn.h"

namespace slicefarm::texture {
namespace {

constexpr double kFar = 250;            // energy of a triangle above which its reference moves
constexpr double kBarrierShare = 1e-8;  // weight as a share of the surface's area
constexpr double kInfinity = std::numeric_limits<double>::infinity();

MapPoints PointsAt(const MapPoints& points, const std::vector<int32_t>& which) {
  MapPoints result;
  result.reserve(which.size());
  for (const int32_t p : which) result.push_back(points[p]);
  return result;
}

/// Returns the smallest area that the undistorted shape of a shell triangle gets.
double LeastShellArea(const MapPoints& points, const BoundaryLoop& outer) {
  double shortest = kInfinity;
  for (size_t i = 0; i < outer.size(); ++i)
    shortest =
        std::min(shortest, (points[outer[(i + 1) % outer.size()]] - points[outer[i]]).norm());
  return shortest * shortest / 4;
}

/// Returns the smallest positive root of a + b t + c t^2 for a > 0; infinity if there is none.
double FirstRoot(double a, double b, double c) {
  const double under = b * b - 4 * a * c;
  if (under < 0) return kInfinity;
  const double root = std::sqrt(under);
  if (b < 0) return 2 * a / (-b + root);
  return c < 0 ? (b + root) / (-2 * c) : kInfinity;
}

}  // namespace

FlatProblem::FlatProblem(const SurfaceMesh& mesh, const BoundaryLoop& outer, const Shell& shell,
                         const MapPoints& points)
    : triangles_(mesh.triangles),
      frame_(shell.frame),
      barrier_(PointsAt(points, shell.frame)),
      surface_count_(mesh.triangles.size()),
      point_count_(static_cast<int32_t>(points.size())) {
  for (const auto& [a, b, c] : mesh.triangles) {
    rests_.push_back(RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]));
    area_ += rests_.back().area;
  }
  const double least = LeastShellArea(points, outer);
  for (const Corners& t : shell.triangles) {
    triangles_.push_back(t);
    const RestTriangle rest = RestOf(points[t[0]], points[t[1]], points[t[2]]);
    rests_.push_back(rest.area < least ? EquilateralRest(least) : rest);
  }
  references_ = rests_;
}

double FlatProblem::BarrierWeight() const { return kBarrierShare * area_; }

void FlatProblem::WeighShell(double share) {
  shell_weight_ = share * area_ / static_cast<double>(triangles_.size() - surface_count_);
}

MapPoints FlatProblem::FrameOf(const MapPoints& points) const { return PointsAt(points, frame_); }

Eigen::Matrix2d FlatProblem::JacobianAt(const MapPoints& points, size_t triangle,
                                        const RestTriangle& rest) const {
  const auto& [a, b, c] = triangles_[triangle];
  return JacobianOf(rest, points[a], points[b], points[c]);
}

double FlatProblem::MeanEnergy(const MapPoints& points) const {
  double sum = 0;
  for (size_t t = 0; t < surface_count_; ++t)
    sum += rests_[t].area * SymmetricDirichlet(JacobianAt(points, t, rests_[t]));
  return sum / area_ / 4;
}

double FlatProblem::TotalEnergy(const MapPoints& points) const {
  double sum = 0;
  for (size_t t = 0; t < triangles_.size(); ++t)
    sum += WeightOf(t) * SymmetricDirichlet(JacobianAt(points, t, references_[t]));
  if (!std::isfinite(sum)) return kInfinity;
  const MapPoints frame = FrameOf(points);
  if (CrossesItself(frame)) return kInfinity;
  return sum + BarrierWeight() * barrier_.Energy(frame);
}

bool FlatProblem::ApproachReferences(const MapPoints& points) {
  bool exact = true;
  for (size_t t = 0; t < surface_count_; ++t) {
    const Eigen::Matrix2d jacobian = JacobianAt(points, t, rests_[t]);
    const bool near = SymmetricDirichlet(jacobian) <= kFar;
    references_[t] = near ? rests_[t] : NearerRest(rests_[t], jacobian, kFar);
    exact &= near;
  }
  return exact;
}

double FlatProblem::StepBound(const MapPoints& points, const MapPoints& direction) const {
  double bound = kInfinity;
  for (const auto& [a, b, c] : triangles_) {
    const Eigen::Vector2d p = points[b] - points[a], q = points[c] - points[a];
    const Eigen::Vector2d u = direction[b] - direction[a], v = direction[c] - direction[a];
    bound = std::min(bound, FirstRoot(Cross(p, q), Cross(p, v) + Cross(u, q), Cross(u, v)));
  }
  return bound;
}

bool FlatProblem::IsOneToOne(const MapPoints& points) const {
  return std::all_of(triangles_.begin(), triangles_.end(),
                     [&](const Corners& t) {
                       return ExactTurn(points[t[0]], points[t[1]], points[t[2]]) > 0;
                     }) &&
         !CrossesItself(FrameOf(points));
}

}  // namespace slicefarm::texture
