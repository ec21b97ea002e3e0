#include "services/texture/algo/map/flatten.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"
#include "services/texture/algo/map/flat_problem.h"
#include "services/texture/algo/map/newton_direction.h"
#include "services/texture/algo/map/shell.h"
#include "services/texture/algo/map/tutte.h"
#include "services/texture/algo/surface/disk.h"

namespace slicefarm::texture {
namespace {

constexpr double kSufficientDecrease = 1e-4;  // Armijo condition
constexpr double kFarDrop = 0.1;    // energy drop per iteration above which the map is far
constexpr double kNearDrop = 0.01;  // energy drop per iteration below which the map is near the end
constexpr double kStalledGain = 1e-3;
constexpr int kPatience = 8;  // iterations in a row with less gain before true references are used
constexpr double kLeastStep = 1e-14;

/// Phase of the minimization. The weight of the shell decreases from phase to phase; in the last
/// one, the shell only prevents overlaps. Source: EBP (Su, Ye, Liu, Fu 2020).
struct ShellPhase {
  double share = 0;  ///< weight of the whole shell, as a share of the surface's area
  /// relative decrease of the energy per iteration at which the next phase begins
  double until = 0;
};
constexpr ShellPhase kPhases[] = {{1e-3, 1e-3}, {4e-5, 1e-4}, {4e-8, 0}};

void MoveTo(const MapPoints& from, const MapPoints& direction, double step, MapPoints* to) {
  for (size_t i = 0; i < from.size(); ++i) (*to)[i] = from[i] + step * direction[i];
}

/// Moves the points along a descent direction. Doubles the step as long as the energy decreases,
/// because a Hessian without its negative eigenvalues gives short steps. Returns false if no step
/// decreases the energy.
bool Descend(const FlatProblem& problem, const NewtonDirection::Descent& path, MapPoints* points) {
  const MapPoints from = *points;
  const double start = problem.TotalEnergy(from);
  const double bound = problem.StepBound(from, path.direction);
  double step = std::min(1.0, 0.9 * bound);
  double reached = start;
  for (;; step /= 2) {
    if (step < kLeastStep) return false;
    MoveTo(from, path.direction, step, points);
    reached = problem.TotalEnergy(*points);
    if (reached <= start + kSufficientDecrease * step * path.slope) break;
    *points = from;
  }
  MapPoints further(from.size());
  for (step *= 2; step > 1 && step < 0.5 * bound; step *= 2) {
    MoveTo(from, path.direction, step, &further);
    const double energy = problem.TotalEnergy(further);
    if (!(energy < reached)) break;
    reached = energy;
    std::swap(*points, further);
  }
  return true;
}

/// Minimizes the energy, starting from the given points. Returns the number of iterations.
absl::StatusOr<int> Minimize(FlatProblem& problem, const FlattenOptions& options,
                             const CancelToken& cancel, MapPoints* points) {
  NewtonDirection newton(problem);
  const ShellPhase* phase = kPhases;
  bool progressive = true;
  double drop = 1;
  int stalled = 0;
  for (int i = 0; i < options.max_iterations; ++i) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const double before = problem.MeanEnergy(*points);
    problem.WeighShell(phase == kPhases ? phase->share * before * 4 : phase->share);
    const bool exact = !progressive || problem.ApproachReferences(*points);
    if (!progressive) problem.TakeTrueReferences();
    const auto path = newton.At(problem, *points,
                                drop > kFarDrop    ? NewtonDirection::Model::kProxy
                                : drop > kNearDrop ? NewtonDirection::Model::kNewton
                                                   : NewtonDirection::Model::kConjugate);
    if (!path.ok()) return path.status();
    const double total = problem.TotalEnergy(*points);
    const bool moved = Descend(problem, *path, points);
    const double gain = (total - problem.TotalEnergy(*points)) / total;
    drop = (before - problem.MeanEnergy(*points)) / before;
    stalled = gain < kStalledGain ? stalled + 1 : 0;
    // If the map does not come closer to the true shapes any more, the references near the map are
    // the reason. Then the true shapes become the references.
    if (exact ? drop < kNearDrop : stalled == kPatience) progressive = false;
    if (!exact) continue;
    const bool last = phase + 1 == std::end(kPhases);
    if (last && (!moved || gain < options.least_drop)) return i + 1;
    if (!last && gain < phase->until) ++phase;
  }
  return options.max_iterations;
}

}  // namespace

absl::StatusOr<FlatMap> Flatten(const SurfaceMesh& mesh, const FlattenOptions& options,
                                const CancelToken& cancel) {
  const auto loops = BoundaryOfDisk(mesh);
  if (!loops.ok()) return loops.status();
  auto first = TutteEmbedding(mesh, *loops);
  if (!first.ok()) return first.status();
  const auto shell = ShellAround(*first, *loops);
  if (!shell.ok()) return shell.status();
  MapPoints points = std::move(first->points);
  points.insert(points.end(), shell->points.begin(), shell->points.end());
  FlatProblem problem(mesh, loops->front(), *shell, points);
  const auto iterations = Minimize(problem, options, cancel, &points);
  if (!iterations.ok()) return iterations.status();
  if (!problem.IsOneToOne(points))
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     "the surface's map is not one-to-one");
  FlatMap map{
      .points_mm = {}, .mean_energy = problem.MeanEnergy(points), .iterations = *iterations};
  points.resize(mesh.points_mm.size());
  map.points_mm = std::move(points);
  return map;
}

}  // namespace slicefarm::texture
