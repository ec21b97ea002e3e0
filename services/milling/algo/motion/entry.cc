#include "services/milling/algo/motion/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "services/milling/algo/motion/inside_area.h"

namespace slicefarm::milling {
namespace {

constexpr int kCircleChords = 24;
/// Largest radius of a helix, as a fraction of the cutter's radius. A larger helix would leave an
/// uncut core in its middle.
constexpr double kMostHelixShare = 0.9;

Eigen::Vector2d LeftOf(const Eigen::Vector2d& direction) { return {-direction.y(), direction.x()}; }

/// Returns the unit direction in which a pass leaves its first point.
Eigen::Vector2d StartDirection(const ClosedPath& pass) {
  for (size_t i = 1; i < pass.size(); ++i)
    if (const Eigen::Vector2d d = pass[i] - pass[0]; d.norm() > 1e-6) return d.normalized();
  return {1, 0};
}

/// Returns an arc of `turn` radians of a circle, beginning at a point.
std::vector<Eigen::Vector2d> ArcLine(const Eigen::Vector2d& centre, const Eigen::Vector2d& from,
                                     double turn) {
  std::vector<Eigen::Vector2d> line;
  const Eigen::Vector2d arm = from - centre;
  for (int k = 0; k <= kCircleChords; ++k) {
    const double c = Cos(turn * k / kCircleChords), s = Sin(turn * k / kCircleChords);
    line.push_back(centre + Eigen::Vector2d(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y()));
  }
  return line;
}

}  // namespace

std::optional<LeadArcs> LeadArcsOf(const ClosedPath& pass, const PolygonWithHoles& area,
                                   double radius_mm, CutDirection direction) {
  if (radius_mm <= 0) return std::nullopt;
  const double side = direction == CutDirection::kClimb ? 1 : -1;
  const Eigen::Vector2d along = StartDirection(pass), free = side * LeftOf(along);
  const Eigen::Vector2d centre = pass[0] + radius_mm * free;
  const LeadArcs arcs{.from = centre - radius_mm * along,
                      .start = pass[0],
                      .to = centre + radius_mm * along,
                      .centre = centre,
                      .clockwise = side < 0};
  const double quarter = side * std::numbers::pi / 2;
  if (!InsideArea(area, ArcLine(centre, arcs.from, quarter)) ||
      !InsideArea(area, ArcLine(centre, arcs.start, quarter)))
    return std::nullopt;
  return arcs;
}

bool HelixDown(const ClosedPath& pass, const PolygonWithHoles& area, double z_mm,
               const MillingOptions& options, MoveBuilder& moves) {
  const double wanted = options.machining.helix_radius_mm;
  const double most = kMostHelixShare * options.cutter.radius_mm();
  const double radius = wanted > 0 ? std::min(wanted, most) : options.cutter.radius_mm() / 2;
  const Eigen::Vector2d start = moves.at().head<2>();
  const Eigen::Vector2d centre = start + radius * LeftOf(StartDirection(pass));
  if (!InsideArea(area, ArcLine(centre, start, 2 * std::numbers::pi))) return false;
  const double depth = moves.at().z() - z_mm, top = moves.at().z();
  const double slope = Tan(options.machining.ramp_angle_deg * std::numbers::pi / 180);
  const double halves = 2 * std::ceil(depth / (2 * std::numbers::pi * radius * slope));
  for (double k = 1; k <= halves; ++k) {
    const Eigen::Vector2d to = static_cast<int>(k) % 2 == 1 ? 2 * centre - start : start;
    moves.ArcTo({to.x(), to.y(), top - depth * k / halves}, centre, false,
                options.machining.plunge_feed_mm_min);
  }
  return true;
}

ClosedPath RampDown(const ClosedPath& pass, double z_mm, const MillingOptions& options,
                    MoveBuilder& moves) {
  const double slope = Tan(options.machining.ramp_angle_deg * std::numbers::pi / 180);
  const double feed = options.machining.plunge_feed_mm_min;
  double z = moves.at().z();
  size_t next = pass.size() > 1 ? 1 : 0;
  Eigen::Vector2d at = pass[0];
  for (;;) {
    const Eigen::Vector2d leg = pass[next] - at;
    const double length = leg.norm(), left = (z - z_mm) / slope;
    if (left <= length || pass.size() < 2) {
      if (length > 0) at += leg * std::min(1.0, left / length);
      moves.LineTo({at.x(), at.y(), z_mm}, feed);
      break;
    }
    z -= length * slope;
    at = pass[next];
    moves.LineTo({at.x(), at.y(), z}, feed);
    next = (next + 1) % pass.size();
  }
  ClosedPath rest = {at};
  for (size_t k = 0; k < pass.size(); ++k) rest.push_back(pass[(next + k) % pass.size()]);
  return rest;
}

}  // namespace slicefarm::milling
