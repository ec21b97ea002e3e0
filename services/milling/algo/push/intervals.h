#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace slicefarm::milling {

/// Element of the mesh that the cutter touches: a triangle, and a part of it. Parts 0 to 2 are the
/// triangle's sides, part 3 is its inside.
struct Source {
  uint32_t triangle = 0;
  uint32_t part = 0;

  friend bool operator==(const Source&, const Source&) = default;
};

/// Open interval of a fiber, in mm along the fiber, in which the cutter gouges. At the ends of the
/// interval the cutter touches the mesh.
struct Interval {
  double low = 0;
  double high = 0;
  Source low_source;
  Source high_source;
};

/// Union of intervals, disjoint and ascending.
class IntervalSet {
 public:
  /// Removes all intervals.
  void Clear() { items_.clear(); }
  /// Adds an interval and merges it with intervals that overlap it or are at most kMerged away. If
  /// two intervals have the same end, the merged interval has the source of the interval added
  /// first. Cost: O(log n) to find, O(n) to move the following intervals, for n intervals.
  /// REQUIRES: low < high.
  void Add(const Interval& interval);
  /// Returns true if one of the intervals contains [low, high]. Cost: O(log n).
  bool Covers(double low, double high) const {
    const auto after = std::partition_point(items_.begin(), items_.end(),
                                            [&](const Interval& item) { return item.low <= low; });
    return after != items_.begin() && (after - 1)->high >= high;
  }

  /// Returns the intervals, ascending.
  const std::vector<Interval>& items() const { return items_; }

  /// Largest gap that counts as rounding, in mm.
  static constexpr double kMerged = 1e-9;

 private:
  std::vector<Interval> items_;
};

}  // namespace slicefarm::milling
