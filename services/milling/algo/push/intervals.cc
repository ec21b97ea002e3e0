#include "services/milling/algo/push/intervals.h"

#include <algorithm>

namespace slicefarm::milling {

void IntervalSet::Add(const Interval& interval) {
  const auto first = std::partition_point(items_.begin(), items_.end(), [&](const Interval& item) {
    return item.high < interval.low - kMerged;
  });
  auto last = first;
  Interval all = interval;
  for (; last != items_.end() && last->low <= interval.high + kMerged; ++last) {
    if (last->low <= all.low) all.low = last->low, all.low_source = last->low_source;
    if (last->high >= all.high) all.high = last->high, all.high_source = last->high_source;
  }
  if (first == last) {
    items_.insert(first, all);
    return;
  }
  *first = all;
  items_.erase(first + 1, last);
}

}  // namespace slicefarm::milling
