#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "absl/status/statusor.h"
#include "services/texture/algo/map/flat_problem.h"
#include "services/texture/algo/map/sparse_cholesky.h"

namespace slicefarm::texture {

/// Ways downhill for a FlatProblem: one sparse system, analysed once.
class NewtonDirection {
 public:
  enum class Model {
    kProxy,      ///< far from the shapes: ProxyOf
    kNewton,     ///< ModelOf
    kConjugate,  ///< and a part of the way before: near the end the cut Hessian alone is slow
  };

  explicit NewtonDirection(const FlatProblem& problem);

  struct Way {
    MapPoints direction;
    double slope = 0;  ///< of the energy along it, below 0
  };

  /// Errors: INTERNAL. Cost: a factorization.
  absl::StatusOr<Way> At(const FlatProblem& problem, const MapPoints& points, Model model);

 private:
  void Assemble(const FlatProblem& problem, const MapPoints& points, Model model);
  void Add(const LocalModel& model, const Corners& corners, const std::array<int32_t, 21>& entries,
           double weight);
  Eigen::VectorXd Conjugate(const Eigen::VectorXd& newton, Model model);

  SparseCholesky system_;
  std::vector<std::array<int32_t, 21>> entries_;  ///< of each triangle's lower block, in values()
  std::vector<int32_t> diagonal_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd last_newton_, last_way_;
  double last_decrement_ = 0;  ///< 0: no way before
};

}  // namespace slicefarm::texture
