#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/map/flat_problem.h"
#include "services/texture/algo/map/sparse_cholesky.h"

namespace slicefarm::texture {

/// Computes descent directions for a FlatProblem, each by one sparse system. The positions of the
/// system's entries are analysed once.
class NewtonDirection {
 public:
  /// Model of the energy.
  enum class Model {
    kProxy,   ///< ProxyOf, for maps far from the true shapes
    kNewton,  ///< ModelOf
    /// ModelOf, plus a part of the previous direction. Used near the minimum. ModelOf alone
    /// converges slowly there, because negative eigenvalues of its Hessian are replaced by 0.
    kConjugate,
  };

  explicit NewtonDirection(const FlatProblem& problem);

  /// Descent direction.
  struct Descent {
    MapPoints direction;
    double slope = 0;  ///< derivative of the energy along the direction; below 0
  };

  /// Returns a descent direction at `points`. Errors: INTERNAL. Cost: a sparse factorization.
  absl::StatusOr<Descent> At(const FlatProblem& problem, const MapPoints& points, Model model);

 private:
  void Assemble(const FlatProblem& problem, const MapPoints& points, Model model);
  void Add(const LocalModel& model, const Corners& corners, const std::array<int32_t, 21>& entries,
           double weight);
  Eigen::VectorXd Conjugate(const Eigen::VectorXd& newton, Model model);

  SparseCholesky system_;
  /// Indices in SparseCholesky::values() of the lower half of each triangle's 6 x 6 Hessian.
  std::vector<std::array<int32_t, 21>> entries_;
  std::vector<int32_t> diagonal_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd last_newton_, last_travel_;
  double last_decrement_ = 0;  ///< decrement of the previous step; 0: there was none
};

}  // namespace slicefarm::texture
