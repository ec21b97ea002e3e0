#include "services/texture/algo/map/sparse_cholesky.h"

#include <suitesparse/cholmod.h>

#include <algorithm>

#include "common/base/error.h"
#include "services/texture/algo/map/thread_random.h"

namespace slicefarm::texture {

struct SparseCholesky::Impl {
  cholmod_common common;
  cholmod_sparse* matrix = nullptr;  ///< lower triangle, columns in order, rows sorted
  cholmod_factor* factor = nullptr;

  Impl() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
  }
  ~Impl() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
    cholmod_finish(&common);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  int32_t* columns() const { return static_cast<int32_t*>(matrix->p); }
  int32_t* rows() const { return static_cast<int32_t*>(matrix->i); }
  double* numbers() const { return static_cast<double*>(matrix->x); }
};

SparseCholesky::SparseCholesky(int32_t size, std::span<const Place> places)
    : impl_(std::make_unique<Impl>()) {
  std::vector<Place> lower;  // column and row
  lower.reserve(places.size() + static_cast<size_t>(size));
  for (const auto& [row, column] : places)
    lower.emplace_back(std::min(row, column), std::max(row, column));
  for (int32_t i = 0; i < size; ++i) lower.emplace_back(i, i);
  std::sort(lower.begin(), lower.end());
  lower.erase(std::unique(lower.begin(), lower.end()), lower.end());

  const auto n = static_cast<size_t>(size);
  impl_->matrix =
      cholmod_allocate_sparse(n, n, lower.size(), 1, 1, -1, CHOLMOD_REAL, &impl_->common);
  std::fill(impl_->columns(), impl_->columns() + n + 1, 0);
  for (size_t i = 0; i < lower.size(); ++i) {
    ++impl_->columns()[lower[i].first + 1];
    impl_->rows()[i] = lower[i].second;
    impl_->numbers()[i] = 0;
  }
  for (size_t i = 0; i < n; ++i) impl_->columns()[i + 1] += impl_->columns()[i];
  SeedThreadRandom(1);  // as METIS, which orders, seeds it again
  impl_->factor = cholmod_analyze(impl_->matrix, &impl_->common);
}

SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;

int32_t SparseCholesky::IndexOf(int32_t row, int32_t column) const {
  if (row < column) std::swap(row, column);
  const int32_t* begin = impl_->rows() + impl_->columns()[column];
  const int32_t* end = impl_->rows() + impl_->columns()[column + 1];
  return static_cast<int32_t>(std::lower_bound(begin, end, row) - impl_->rows());
}

std::span<double> SparseCholesky::values() { return {impl_->numbers(), impl_->matrix->nzmax}; }

absl::Status SparseCholesky::Factor() {
  if (impl_->factor != nullptr) cholmod_factorize(impl_->matrix, impl_->factor, &impl_->common);
  if (impl_->factor == nullptr || impl_->common.status != CHOLMOD_OK ||
      impl_->factor->minor < impl_->factor->n)
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     "a system of the surface's map is not positive definite");
  return absl::OkStatus();
}

Eigen::VectorXd SparseCholesky::Solve(const Eigen::VectorXd& right) const {
  cholmod_dense view = {};
  view.nrow = view.nzmax = view.d = static_cast<size_t>(right.size());
  view.ncol = 1;
  view.x = const_cast<double*>(right.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* solved = cholmod_solve(CHOLMOD_A, impl_->factor, &view, &impl_->common);
  Eigen::VectorXd result =
      Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solved->x), right.size());
  cholmod_free_dense(&solved, &impl_->common);
  return result;
}

}  // namespace slicefarm::texture
