#include "services/texture/algo/map/newton_direction.h"

#include <algorithm>
#include <utility>

namespace slicefarm::texture {
namespace {

constexpr double kHold = 1e-9;  // share of the mean diagonal; fixes the map's position

/// Returns the pairs of points that occur together in a term of the energy.
std::vector<SparseCholesky::BlockIndex> BlocksOf(const FlatProblem& problem) {
  std::vector<SparseCholesky::BlockIndex> indices;
  indices.reserve(3 * problem.triangles().size());
  for (const Corners& t : problem.triangles())
    for (int k = 0; k < 3; ++k) indices.emplace_back(t[k], t[(k + 1) % 3]);
  for (const int32_t a : problem.frame()) {
    for (const int32_t b : problem.frame()) {
      if (a < b) indices.emplace_back(a, b);
    }
  }
  return indices;
}

/// Returns the row of the i-th coordinate of three corners' 6 x 6 block.
int32_t RowOf(const Corners& corners, int i) { return 2 * corners[i / 2] + i % 2; }

std::array<int32_t, 21> EntriesOf(const SparseCholesky& system, const Corners& corners) {
  std::array<int32_t, 21> entries;
  int at = 0;
  for (int i = 0; i < 6; ++i) {
    for (int k = 0; k <= i; ++k)
      entries[at++] = system.IndexOf(RowOf(corners, i), RowOf(corners, k));
  }
  return entries;
}

}  // namespace

NewtonDirection::NewtonDirection(const FlatProblem& problem)
    : system_(problem.point_count(), BlocksOf(problem), 2) {
  entries_.reserve(problem.triangles().size());
  for (const Corners& t : problem.triangles()) entries_.push_back(EntriesOf(system_, t));
  for (int32_t i = 0; i < 2 * problem.point_count(); ++i)
    diagonal_.push_back(system_.IndexOf(i, i));
}

void NewtonDirection::Add(const LocalModel& model, const Corners& corners,
                          const std::array<int32_t, 21>& entries, double weight) {
  const std::span<double> values = system_.values();
  int at = 0;
  for (int i = 0; i < 6; ++i) {
    gradient_[RowOf(corners, i)] += weight * model.gradient[i];
    for (int k = 0; k <= i; ++k) values[entries[at++]] += weight * model.hessian(i, k);
  }
}

void NewtonDirection::Assemble(const FlatProblem& problem, const MapPoints& points, Model model) {
  const std::span<double> values = system_.values();
  std::fill(values.begin(), values.end(), 0);
  gradient_.setZero(static_cast<Eigen::Index>(diagonal_.size()));
  for (size_t t = 0; t < problem.triangles().size(); ++t) {
    const RestTriangle& rest = problem.references()[t];
    const Eigen::Matrix2d jacobian = problem.JacobianAt(points, t, rest);
    Add(model == Model::kProxy ? ProxyOf(jacobian, rest) : ModelOf(jacobian, rest),
        problem.triangles()[t], entries_[t], problem.WeightOf(t));
  }
  for (const FrameBarrier::Term& term : problem.barrier().Terms(problem.FrameOf(points))) {
    const auto& [a, b, point] = term.pair;
    const Corners corners = {problem.frame()[a], problem.frame()[b], problem.frame()[point]};
    Add(term.model, corners, EntriesOf(system_, corners), problem.BarrierWeight());
  }
  double trace = 0;
  for (const int32_t entry : diagonal_) trace += values[entry];
  const double hold = kHold * trace / static_cast<double>(diagonal_.size());
  for (const int32_t entry : diagonal_) values[entry] += hold;
}

/// Adds a part of the previous direction by the Polak-Ribiere rule, with the factored Hessian as
/// the metric.
Eigen::VectorXd NewtonDirection::Conjugate(const Eigen::VectorXd& newton, Model model) {
  Eigen::VectorXd path = newton;
  if (model == Model::kConjugate && last_decrement_ > 0) {
    const double part = -gradient_.dot(newton - last_newton_) / last_decrement_;
    if (part > 0) path += part * last_travel_;
    if (gradient_.dot(path) >= 0) path = newton;
  }
  last_newton_ = newton;
  last_travel_ = path;
  last_decrement_ = model == Model::kConjugate ? -gradient_.dot(newton) : 0;
  return path;
}

absl::StatusOr<NewtonDirection::Descent> NewtonDirection::At(const FlatProblem& problem,
                                                             const MapPoints& points, Model model) {
  Assemble(problem, points, model);
  if (absl::Status status = system_.Factor(); !status.ok()) return status;
  const Eigen::VectorXd solved = Conjugate(system_.Solve(-gradient_), model);
  Descent path{.direction = MapPoints(points.size()), .slope = gradient_.dot(solved)};
  for (size_t i = 0; i < points.size(); ++i)
    path.direction[i] = solved.segment<2>(2 * static_cast<Eigen::Index>(i));
  return path;
}

}  // namespace slicefarm::texture
