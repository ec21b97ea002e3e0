#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "absl/status/status.h"

namespace slicefarm::texture {

/// A symmetric positive definite system whose pattern stays while its numbers change: ordered and
/// analysed once, factored as often as asked. Source: CHOLMOD, supernodal (Chen, Davis, Hager,
/// Rajamanickam 2008), with one thread: the same bytes each time.
class SparseCholesky {
 public:
  /// Row and column of an entry.
  using Place = std::pair<int32_t, int32_t>;

  /// `places`: all entries that may ever be other than 0, of either triangle, in any order,
  /// repeated as one likes. The diagonal is added.
  SparseCholesky(int32_t size, std::span<const Place> places);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;

  /// Where the entry's number is in values(). REQUIRES: it is one of the places. O(log n).
  int32_t IndexOf(int32_t row, int32_t column) const;

  /// The numbers of the lower triangle.
  std::span<double> values();

  /// Errors: INTERNAL if the numbers are not positive definite.
  absl::Status Factor();
  /// REQUIRES: Factor succeeded.
  Eigen::VectorXd Solve(const Eigen::VectorXd& right) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace slicefarm::texture
