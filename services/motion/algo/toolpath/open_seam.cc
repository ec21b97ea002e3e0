#include "services/motion/algo/toolpath/open_seam.h"

#include "common/geometry/between.h"
#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

/// Shortest loop that gets a gap, in gaps. A shorter loop would consist mostly of its gap.
constexpr double kLeastGaps = 4;

}  // namespace

SimplifiedPath WithOpenSeam(SimplifiedPath simple, Coord gap_nm) {
  Path& path = simple.path;
  auto left = static_cast<double>(gap_nm);
  if (!path.closed || left <= 0 || PathLength(path) <= kLeastGaps * left) return simple;
  path.closed = false;
  path.points.push_back(path.points.front());
  if (path.widths_nm.size() > 1) path.widths_nm.push_back(path.widths_nm.front());
  while (true) {
    const Point last = path.points.back(), before = path.points[path.points.size() - 2];
    const double length = Distance(before, last);
    if (length > left) {
      path.points.back() = PointBetween(last, before, left / length);
      return simple;
    }
    left -= length;
    path.points.pop_back();
    if (path.widths_nm.size() > 1) path.widths_nm.pop_back();
    simple.on_arc.pop_back();
  }
}

}  // namespace slicefarm::motion
