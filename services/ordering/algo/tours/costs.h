#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/vector.h"

namespace slicefarm::ordering {

/// Rounding of lengths between points to whole units. The first three are TSPLIB's EUC_2D, CEIL_2D
/// and ATT. kTable reads lengths from a table.
enum class Metric : uint8_t { kNearest, kUp, kAtt, kTable };

/// Symmetric lengths between the nodes 0 .. size() - 1, in whole units. Sums and differences of
/// lengths are therefore exact.
class Costs {
 public:
  /// Returns the costs for points in the plane (`points`). REQUIRES: metric is not kTable.
  static Costs OfPoints(std::vector<Vector2> points, Metric metric);
  /// Returns the costs given by a table. `lengths`: size * size values, row by row, symmetric.
  static Costs OfTable(int32_t size, std::vector<int32_t> lengths);

  /// Adds a node with distance 0 to every node and returns its number. This "nowhere" node stands
  /// for the missing end of an open path.
  int32_t AddNowhere();

  int32_t size() const { return size_; }
  bool has_points() const { return metric_ != Metric::kTable; }
  bool IsNowhere(int32_t node) const { return node == nowhere_; }
  const std::vector<Vector2>& points() const { return points_; }

  /// Returns the length between nodes a and b.
  int64_t operator()(int32_t a, int32_t b) const {
    if (metric_ == Metric::kTable) return Looked(a, b);
    if (a == nowhere_ || b == nowhere_) return 0;
    const Vector2& p = points_[static_cast<size_t>(a)];
    const Vector2& q = points_[static_cast<size_t>(b)];
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
  std::vector<Vector2> points_;
  std::vector<int32_t> table_;
};

/// Returns the length of the closed tour, including the edge from the last node to the first.
int64_t TourLength(const Costs& costs, const std::vector<int32_t>& tour);

}  // namespace slicefarm::ordering
