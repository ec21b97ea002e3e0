#include "services/milling/algo/motion/mill_move.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm::milling {
namespace {

/// Returns the angle of an arc in radians, up to a whole turn. It is a whole turn if the start
/// equals the end.
double ArcTurn(const MillMove& move, const Eigen::Vector3d& from_mm) {
  Eigen::Vector2d a = from_mm.head<2>() - move.centre_mm, b = move.to_mm.head<2>() - move.centre_mm;
  if (move.kind == MoveKind::kClockwise) std::swap(a, b);
  if (a == b) return 2 * std::numbers::pi;
  const double turn = Atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  return turn > 0 ? turn : turn + 2 * std::numbers::pi;
}

bool IsArc(const MillMove& move) {
  return move.kind == MoveKind::kClockwise || move.kind == MoveKind::kCounterClockwise;
}

}  // namespace

double LengthOf(const MillMove& move, const Eigen::Vector3d& from_mm) {
  if (!IsArc(move)) return (move.to_mm - from_mm).norm();
  const double flat = ArcTurn(move, from_mm) * (from_mm.head<2>() - move.centre_mm).norm();
  return Hypot(flat, move.to_mm.z() - from_mm.z());
}

std::vector<Eigen::Vector3d> PointsOf(const MillMove& move, const Eigen::Vector3d& from_mm,
                                      double tolerance_mm) {
  std::vector<Eigen::Vector3d> points;
  if (IsArc(move)) {
    const Eigen::Vector2d arm = from_mm.head<2>() - move.centre_mm;
    const double radius = arm.norm(), turn = ArcTurn(move, from_mm);
    const double most = 2 * Acos(std::clamp(1 - tolerance_mm / radius, 0.0, 1.0));
    const double steps = std::max(1.0, std::ceil(turn / most));
    const double sign = move.kind == MoveKind::kClockwise ? -1 : 1;
    for (double k = 1; k < steps; ++k) {
      const double angle = sign * turn * k / steps, c = Cos(angle), s = Sin(angle);
      points.push_back({move.centre_mm.x() + c * arm.x() - s * arm.y(),
                        move.centre_mm.y() + s * arm.x() + c * arm.y(),
                        from_mm.z() + (move.to_mm.z() - from_mm.z()) * k / steps});
    }
  }
  points.push_back(move.to_mm);
  return points;
}

}  // namespace slicefarm::milling
