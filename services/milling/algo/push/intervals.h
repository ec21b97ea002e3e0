#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace slicefarm::milling {

/// Which element of the mesh the cutter touches: part 0 to 2 is a side of the triangle, part 3 its
/// inside.
struct Source {
  uint32_t triangle = 0;
  uint32_t part = 0;

  friend bool operator==(const Source&, const Source&) = default;
};

/// A piece of a fiber on which the cutter gouges, open: at its ends it touches. In mm along it.
struct Interval {
  double low = 0;
  double high = 0;
  Source low_source;
  Source high_source;
};

/// A union of intervals, disjoint and ascending.
class IntervalSet {
 public:
  void Clear() { items_.clear(); }
  /// Unites with what overlaps it or is not farther away than kMerged. Of equal ends the first
  /// one's source stays. Cost: O(log n) to find, O(n) to move what is behind. REQUIRES: low < high.
  void Add(const Interval& interval);
  /// Whether one of the intervals holds [low, high]. Cost: O(log n).
  bool Covers(double low, double high) const {
    const auto after = std::partition_point(items_.begin(), items_.end(),
                                            [&](const Interval& item) { return item.low <= low; });
    return after != items_.begin() && (after - 1)->high >= high;
  }

  const std::vector<Interval>& items() const { return items_; }

  /// Gaps up to this are rounding, in mm.
  static constexpr double kMerged = 1e-9;

 private:
  std::vector<Interval> items_;
};

}  // namespace slicefarm::milling
