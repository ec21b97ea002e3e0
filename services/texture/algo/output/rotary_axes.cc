#include "services/texture/algo/output/rotary_axes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"

namespace slicefarm::texture {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUpright = 1e-9;  // sine of the tilt below which C is arbitrary

Eigen::Matrix3d TurnAbout(int axis, double angle_deg) {
  const double c = Cos(angle_deg * kDegree), s = Sin(angle_deg * kDegree);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(u, u) = turn(v, v) = c;
  turn(u, v) = -s;
  turn(v, u) = s;
  return turn;
}

bool IsTable(AxisLayout layout) {
  return layout == AxisLayout::kTableAb || layout == AxisLayout::kTableBc;
}

/// Returns a rotation matrix: for a table, from the part's coordinates to the machine's; for a
/// head, from the head's coordinates to the part's.
Eigen::Matrix3d TurnOf(AxisLayout layout, const Eigen::Vector2d& angles) {
  switch (layout) {
    case AxisLayout::kNone:
      return Eigen::Matrix3d::Identity();
    case AxisLayout::kTableAb:
      return TurnAbout(0, angles[0]) * TurnAbout(1, angles[1]);
    case AxisLayout::kTableBc:
      return TurnAbout(1, angles[0]) * TurnAbout(2, angles[1]);
    case AxisLayout::kHeadAb:
      return TurnAbout(1, angles[1]) * TurnAbout(0, angles[0]);
    case AxisLayout::kHeadBc:
      return TurnAbout(2, angles[1]) * TurnAbout(1, angles[0]);
  }
  return Eigen::Matrix3d::Identity();
}

/// Returns the two pairs of angles for a normal that is not vertical.
std::array<Eigen::Vector2d, 2> AnglePairs(AxisLayout layout, const Eigen::Vector3d& n) {
  const double flat = Hypot(n.x(), n.y());
  const double tilt = Atan2(flat, n.z()) / kDegree, turn = Atan2(n.y(), n.x()) / kDegree;
  const double beside = Hypot(n.x(), n.z());
  switch (layout) {
    case AxisLayout::kNone:
      break;
    case AxisLayout::kTableBc:
      return {Eigen::Vector2d(-tilt, -turn), Eigen::Vector2d(tilt, 180 - turn)};
    case AxisLayout::kHeadBc:
      return {Eigen::Vector2d(tilt, turn), Eigen::Vector2d(-tilt, turn + 180)};
    case AxisLayout::kTableAb:
      return {Eigen::Vector2d(Atan2(n.y(), beside), Atan2(-n.x(), n.z())) / kDegree,
              Eigen::Vector2d(Atan2(n.y(), -beside), Atan2(n.x(), -n.z())) / kDegree};
    case AxisLayout::kHeadAb:
      return {Eigen::Vector2d(Atan2(-n.y(), beside), Atan2(n.x(), n.z())) / kDegree,
              Eigen::Vector2d(Atan2(-n.y(), -beside), Atan2(-n.x(), -n.z())) / kDegree};
  }
  return {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
}

bool HasC(AxisLayout layout) {
  return layout == AxisLayout::kTableBc || layout == AxisLayout::kHeadBc;
}

}  // namespace

const char* RotaryAxes::Letters() const {
  if (options_.layout == AxisLayout::kNone) return "  ";
  return HasC(options_.layout) ? "BC" : "AB";
}

std::optional<Eigen::Vector2d> RotaryAxes::AnglesFor(const Eigen::Vector3d& normal,
                                                     const Eigen::Vector2d& before) const {
  if (options_.layout == AxisLayout::kNone) return Eigen::Vector2d::Zero();
  const bool has_c = HasC(options_.layout);
  std::optional<Eigen::Vector2d> best;
  for (Eigen::Vector2d angles : AnglePairs(options_.layout, normal)) {
    if (has_c) {
      if (Hypot(normal.x(), normal.y()) < kUpright) angles[1] = before[1];
      angles[1] += 360 * std::round((before[1] - angles[1]) / 360);
    }
    if (std::abs(angles[0]) > options_.tilt_deg ||
        (!has_c && std::abs(angles[1]) > options_.tilt_deg))
      continue;
    const auto far = [&](const Eigen::Vector2d& a) { return (a - before).cwiseAbs().maxCoeff(); };
    if (!best || far(angles) < far(*best)) best = angles;
  }
  return best;
}

Eigen::Vector3d RotaryAxes::XyzFor(const Eigen::Vector3d& place_mm,
                                   const Eigen::Vector2d& angles_deg) const {
  const Eigen::Matrix3d turn = TurnOf(options_.layout, angles_deg);
  if (IsTable(options_.layout)) return turn * (place_mm - options_.centre_mm) + options_.centre_mm;
  const Eigen::Vector3d up(0, 0, 1);
  return place_mm + options_.pivot_mm * (turn * up - up);
}

Eigen::Vector3d RotaryAxes::TipAt(const AxisValues& at) const {
  const Eigen::Matrix3d turn = TurnOf(options_.layout, at.angles_deg);
  if (IsTable(options_.layout))
    return turn.transpose() * (at.xyz_mm - options_.centre_mm) + options_.centre_mm;
  const Eigen::Vector3d up(0, 0, 1);
  return at.xyz_mm - options_.pivot_mm * (turn * up - up);
}

}  // namespace slicefarm::texture
