#include "services/motion/algo/toolpath/arc_chords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"

namespace slicefarm::motion {
namespace {

/// Largest number of chords of an arc. No printed arc needs so many; the limit bounds the memory
/// for hostile files.
constexpr double kMostChords = 2e4;

}  // namespace

double Arc::StartRadius() const { return Hypot(from.x() - centre.x(), from.y() - centre.y()); }
double Arc::EndRadius() const { return Hypot(to.x() - centre.x(), to.y() - centre.y()); }

double Arc::Angle() const {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (from == to) return kTurn;
  const double ax = from.x() - centre.x(), ay = from.y() - centre.y();
  const double bx = to.x() - centre.x(), by = to.y() - centre.y();
  const double turn = Atan2(ax * by - ay * bx, ax * bx + ay * by);
  const double angle = clockwise ? -turn : turn;
  return angle > 0 ? angle : angle + kTurn;
}

Vector2 CentreByRadius(Vector2 from, Vector2 to, double radius, bool clockwise) {
  const double dx = to.x() - from.x(), dy = to.y() - from.y();
  const double chord2 = dx * dx + dy * dy;
  const double rest2 = std::max(0.0, radius * radius - chord2 / 4);
  const double side = (clockwise == (radius > 0)) ? -1 : 1;
  const double share = side * std::sqrt(rest2 / chord2);
  return {(from.x() + to.x()) / 2 - share * dy, (from.y() + to.y()) / 2 + share * dx};
}

std::vector<Vector2> ArcChords(const Arc& arc, double length_mm, double segment_mm) {
  const double count = std::clamp(std::floor(length_mm / segment_mm), 1.0, kMostChords);
  const double step = (arc.clockwise ? -1 : 1) * arc.Angle() / count;
  const double ax = arc.from.x() - arc.centre.x(), ay = arc.from.y() - arc.centre.y();
  std::vector<Vector2> ends;
  ends.reserve(static_cast<size_t>(count));
  for (double i = 1; i < count; ++i) {
    const double c = Cos(i * step), s = Sin(i * step);
    ends.push_back({arc.centre.x() + ax * c - ay * s, arc.centre.y() + ax * s + ay * c});
  }
  ends.push_back(arc.to);
  return ends;
}

}  // namespace slicefarm::motion
