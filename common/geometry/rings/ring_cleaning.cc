#include "common/geometry/rings/ring_cleaning.h"

#include <cstddef>

#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

/// Adds p to an open line, dropping what it makes superfluous before it.
void Append(Polygon& line, Point p) {
  while (line.size() >= 2 && Orientation(line.end()[-2], line.back(), p) == 0) line.pop_back();
  if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

Polygon CleanedRing(const Polygon& ring) {
  Polygon line;
  line.reserve(ring.size());
  for (const Point p : ring) Append(line, p);
  // Where the line's ends meet, either may be superfluous.
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
