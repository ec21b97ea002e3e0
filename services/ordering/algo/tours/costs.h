#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::ordering {

/// How lengths between places are rounded to whole units. The first three are TSPLIB's EUC_2D,
/// CEIL_2D and ATT; kTable looks them up.
enum class Metric : uint8_t { kNearest, kUp, kAtt, kTable };

/// The symmetric lengths between nodes 0 .. size() - 1, in whole units: sums and differences of
/// them are exact.
class Costs {
 public:
  /// REQUIRES: metric is not kTable.
  static Costs OfPlaces(std::vector<Vector2> places, Metric metric);
  /// `lengths`: row by row, size * size of them, symmetric.
  static Costs OfTable(int32_t size, std::vector<int32_t> lengths);

  /// One more node that is at no distance from any: where an open path ends.
  int32_t AddNowhere();

  int32_t size() const { return size_; }
  bool has_places() const { return metric_ != Metric::kTable; }
  bool IsNowhere(int32_t node) const { return node == nowhere_; }
  const std::vector<Vector2>& places() const { return places_; }

  int64_t operator()(int32_t a, int32_t b) const {
    if (metric_ == Metric::kTable) return Looked(a, b);
    if (a == nowhere_ || b == nowhere_) return 0;
    const Vector2& p = places_[static_cast<size_t>(a)];
    const Vector2& q = places_[static_cast<size_t>(b)];
    const double square = (p.x() - q.x()) * (p.x() - q.x()) + (p.y() - q.y()) * (p.y() - q.y());
    if (metric_ == Metric::kNearest) return static_cast<int64_t>(std::sqrt(square) + 0.5);
    return RoundedUp(square);
  }

 private:
  Costs(int32_t size, Metric metric) : size_(size), metric_(metric) {}

  int64_t Looked(int32_t a, int32_t b) const;
  int64_t RoundedUp(double square) const;

  int32_t size_;
  Metric metric_;
  int32_t nowhere_ = -1;
  std::vector<Vector2> places_;
  std::vector<int32_t> table_;
};

/// Of the closed tour.
int64_t TourLength(const Costs& costs, const std::vector<int32_t>& tour);

}  // namespace slicefarm::ordering
