#include "common/geometry/rings/ring_cleaning.h"

#include <cstddef>

#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

/// Appends p to an open line, and removes earlier points that p makes redundant.
void Append(Polygon& line, Point p) {
  while (line.size() >= 2 && Orientation(line.end()[-2], line.back(), p) == 0) line.pop_back();
  if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

Polygon CleanedRing(const Polygon& ring) {
  Polygon line;
  line.reserve(ring.size());
  for (const Point p : ring) Append(line, p);
  // The first or the last point may be redundant where the ends of the line meet.
  size_t first = 0, last = line.size();
  while (last - first >= 3) {
    if (line[last - 1] == line[first] ||
        Orientation(line[last - 2], line[last - 1], line[first]) == 0) {
      --last;
    } else if (Orientation(line[last - 1], line[first], line[first + 1]) == 0) {
      ++first;
    } else {
      return {line.begin() + static_cast<ptrdiff_t>(first),
              line.begin() + static_cast<ptrdiff_t>(last)};
    }
  }
  return {};
}

}  // namespace slicefarm
