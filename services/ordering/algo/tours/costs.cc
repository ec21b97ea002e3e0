#include "services/ordering/algo/tours/costs.h"

#include <utility>

namespace slicefarm::ordering {

Costs Costs::OfPoints(std::vector<Vector2> points, Metric metric) {
  Costs costs(static_cast<int32_t>(points.size()), metric);
  costs.points_ = std::move(points);
  return costs;
}

Costs Costs::OfTable(int32_t size, std::vector<int32_t> lengths) {
  Costs costs(size, Metric::kTable);
  costs.table_ = std::move(lengths);
  return costs;
}

int32_t Costs::AddNowhere() {
  nowhere_ = size_++;
  if (has_points()) points_.emplace_back();
  return nowhere_;
}

int64_t Costs::Looked(int32_t a, int32_t b) const {
  if (a == nowhere_ || b == nowhere_) return 0;
  const size_t columns = static_cast<size_t>(nowhere_ < 0 ? size_ : size_ - 1);
  return table_[static_cast<size_t>(a) * columns + static_cast<size_t>(b)];
}

int64_t Costs::RoundedUp(double square) const {
  if (metric_ == Metric::kUp) return static_cast<int64_t>(std::ceil(std::sqrt(square)));
  const double exact = std::sqrt(square / 10);
  const auto nearest = static_cast<int64_t>(exact + 0.5);
  return static_cast<double>(nearest) < exact ? nearest + 1 : nearest;
}

int64_t TourLength(const Costs& costs, const std::vector<int32_t>& tour) {
  int64_t length = 0;
  for (size_t i = 0; i < tour.size(); ++i)
    length += costs(tour[i], tour[i + 1 < tour.size() ? i + 1 : 0]);
  return length;
}

}  // namespace slicefarm::ordering
