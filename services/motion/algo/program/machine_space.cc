#include "services/motion/algo/program/machine_space.h"

#include <algorithm>
#include <limits>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

double Mm(Coord nm) { return ToMm(static_cast<double>(nm)); }

/// Returns true if the ring is counter-clockwise without a turn to the right.
bool IsConvex(const Polygon& ring) {
  const size_t count = ring.size();
  for (size_t i = 0; i < count; ++i) {
    const Point a = ring[i], b = ring[(i + 1) % count], c = ring[(i + 2) % count];
    const double turn = Mm(b.x - a.x) * Mm(c.y - b.y) - Mm(b.y - a.y) * Mm(c.x - b.x);
    if (turn < 0) return false;
  }
  return true;
}

Polygon BoxOf(const Polygon& ring) {
  const Box box = Bounds(ring);
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

}  // namespace

MachineSpace::MachineSpace(const Polygon& bed, double max_height_mm, double min_height_mm)
    : max_height_mm_(max_height_mm > 0 ? max_height_mm : std::numeric_limits<double>::max()),
      min_height_mm_(min_height_mm) {
  if (bed.size() < 3) return;
  const Polygon ring = IsConvex(bed) ? bed : BoxOf(bed);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    const double dx = Mm(to.x - from.x), dy = Mm(to.y - from.y);
    const double length = Hypot(dx, dy);
    if (length == 0) continue;
    const double a = dy / length, b = -dx / length;
    sides_.push_back({a, b, a * Mm(from.x) + b * Mm(from.y)});
  }
}

double MachineSpace::OutsideHeight(double z_mm) const {
  return std::max(z_mm - max_height_mm_, min_height_mm_ - z_mm);
}

double MachineSpace::Outside(double x_mm, double y_mm, double z_mm) const {
  double outside = OutsideHeight(z_mm);
  for (const Side& side : sides_)
    outside = std::max(outside, side.a * x_mm + side.b * y_mm - side.c);
  return outside;
}

}  // namespace slicefarm::motion
