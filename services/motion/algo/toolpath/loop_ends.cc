#include "services/motion/algo/toolpath/loop_ends.h"

#include <algorithm>
#include <cmath>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/vector.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion {
namespace {

/// Returns the direction between two points, with length 1. REQUIRES: the points differ.
Vector2 DirectionOf(Point from, Point to) {
  const double length = Distance(from, to);
  return {static_cast<double>(to.x - from.x) / length, static_cast<double>(to.y - from.y) / length};
}

/// Least length of the sum of two directions that is not a reversal.
constexpr double kLeastSum = 0.1;

}  // namespace

Point BesideStart(const Path& path, Coord distance_nm, bool left) {
  const Point start = path.points.front();
  const auto differs = [&](Point point) { return point != start; };
  const auto next = std::ranges::find_if(path.points, differs);
  if (next == path.points.end()) return start;
  const auto before = std::find_if(path.points.rbegin(), path.points.rend(), differs);
  const Vector2 out = DirectionOf(start, *next);
  Vector2 along = DirectionOf(*before, start) + out;
  double length = Hypot(along.x(), along.y());
  if (length < kLeastSum) {
    along = out;
    length = 1;
  }
  const double scale = (left ? 1 : -1) * static_cast<double>(distance_nm) / length;
  return start + Point{std::llround(-along.y() * scale), std::llround(along.x() * scale)};
}

/// Returns the point inside the part beside the start of an outer wall, at the inner edge of its
/// bead. So the nozzle stays over the bead if the part has only one wall.
Point ToolpathBuilder::InsideOf(const Path& path, bool reversed) const {
  const Coord wide = std::min(FromMm(options_.tool().nozzle_diameter_mm), path.WidthAt(0));
  return BesideStart(path, wide / 2, options_.clockwise == reversed);
}

/// Moves without filament at the speed of a bead.
void ToolpathBuilder::GlideTo(Point to, double speed_mm_s) {
  const PointUm place{ToUm(to.x), ToUm(to.y)};
  if (place == PointUm{at_.x_um, at_.y_um}) return;
  stats_.travel_mm += MovesMm({&place, 1});
  at_.x_um = place.x;
  at_.y_um = place.y;
  at_.filament = 0;
  at_.feed_rate = FeedRate(speed_mm_s);
  Push(MoveKind::kTravel, accelerations_.Travel(set_acceleration_));
}

}  // namespace slicefarm::motion
