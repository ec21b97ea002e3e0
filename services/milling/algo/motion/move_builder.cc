#include "services/milling/algo/motion/move_builder.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/arc_fit.h"
#include "common/geometry/rings/simplify.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling {
namespace {

/// Shares of the tolerance: for fitting arcs to points, for fitting lines to points, and for the
/// chords of arcs in the stock map.
constexpr double kArcShare = 0.75;
constexpr double kLineShare = 0.1;
constexpr double kMapShare = 0.5;
/// Smallest tolerance of an arc. It must be larger than the rounding error of its centre.
constexpr double kLeastArcToleranceUm = 1.6;

double WholeMicrometres(double mm) { return static_cast<double>(std::llround(mm * 1000)) / 1000; }

Eigen::Vector3d Rounded(const Eigen::Vector3d& p) {
  return {WholeMicrometres(p.x()), WholeMicrometres(p.y()), WholeMicrometres(p.z())};
}

PointUm MicrometresOf(const Eigen::Vector2d& p) {
  return {static_cast<int32_t>(std::llround(p.x() * 1000)),
          static_cast<int32_t>(std::llround(p.y() * 1000))};
}

Eigen::Vector2d MicronsToMm(PointUm p) { return {p.x / 1000.0, p.y / 1000.0}; }

std::vector<PointUm> PointsInUm(std::span<const Eigen::Vector2d> line_mm) {
  std::vector<PointUm> points;
  for (const Eigen::Vector2d& p : line_mm)
    if (const PointUm um = MicrometresOf(p); points.empty() || points.back() != um)
      points.push_back(um);
  return points;
}

}  // namespace

MoveBuilder::MoveBuilder(const MillingJob& job, const CancelToken& cancel)
    : job_(job),
      stock_(job, StockPixelMm(job), cancel),
      safe_z_mm_(WholeMicrometres(job.stock_box.max().z() + job.options.machining.safe_height_mm)),
      at_(0, 0, safe_z_mm_) {}

void MoveBuilder::Emit(MillMove move) {
  move.phase = phase_;
  move.to_mm = Rounded(move.to_mm);
  if (move.kind != MoveKind::kRapid) {
    Eigen::Vector3d from = at_;
    for (const Eigen::Vector3d& p : PointsOf(move, at_, kMapShare * job_.options.tolerance_mm)) {
      stock_.Cut(from, p);
      from = p;
    }
  }
  at_ = move.to_mm;
  moves_.push_back(move);
}

void MoveBuilder::RapidTo(const Eigen::Vector2d& place_mm, double z_mm) {
  const Eigen::Vector2d place = MicronsToMm(MicrometresOf(place_mm));
  const double clearance = job_.options.machining.clearance_mm;
  if (!placed_) {
    Emit({.to_mm = {place.x(), place.y(), safe_z_mm_}});
    placed_ = true;
  } else {
    const double over = stock_.RestHeightOver(at_.head<2>(), place) + clearance;
    const double up = std::max(at_.z(), std::min(safe_z_mm_, over));
    if (up > at_.z()) Emit({.to_mm = {at_.x(), at_.y(), up}});
    if (at_.head<2>() != place) Emit({.to_mm = {place.x(), place.y(), at_.z()}});
  }
  const double rest = std::max(z_mm, stock_.RestHeight(place, stock_.pixel_mm()));
  const double down = rest + clearance;
  if (down < at_.z()) Emit({.to_mm = {place.x(), place.y(), down}});
}

void MoveBuilder::Retract() {
  if (at_.z() < safe_z_mm_) Emit({.to_mm = {at_.x(), at_.y(), safe_z_mm_}});
}

void MoveBuilder::LineTo(const Eigen::Vector3d& to_mm, double feed_mm_min) {
  if (Rounded(to_mm) == at_) return;
  Emit({.kind = MoveKind::kLine, .to_mm = to_mm, .feed_mm_min = feed_mm_min});
}

void MoveBuilder::ArcTo(const Eigen::Vector3d& to_mm, const Eigen::Vector2d& centre_mm,
                        bool clockwise, double feed_mm_min) {
  const MillMove arc = {.kind = clockwise ? MoveKind::kClockwise : MoveKind::kCounterClockwise,
                        .to_mm = to_mm,
                        .centre_mm = MicronsToMm(MicrometresOf(centre_mm)),
                        .feed_mm_min = feed_mm_min};
  if (job_.options.machining.arcs) return Emit(arc);
  for (const Eigen::Vector3d& p : PointsOf(arc, at_, kArcShare * job_.options.tolerance_mm))
    LineTo(p, feed_mm_min);
}

void MoveBuilder::FeedAlong(std::span<const Eigen::Vector2d> line_mm, double feed_mm_min) {
  const std::vector<PointUm> points = PointsInUm(line_mm);
  if (points.size() < 2) return;
  const double z = at_.z(), tolerance = job_.options.tolerance_mm;
  const Coord chord_nm = FromMm(kLineShare * tolerance);
  Polyline straight = {PointOf(MicronsToMm(points[0]))};
  const auto lines = [&] {
    for (const Point p : SimplifyLine(straight, chord_nm)) {
      const Eigen::Vector2d place = PointMmOf(p);
      LineTo({place.x(), place.y(), z}, feed_mm_min);
    }
  };
  if (!job_.options.machining.arcs) {
    for (const PointUm point : points) straight.push_back(PointOf(MicronsToMm(point)));
    return lines();
  }
  const double arc_um = std::max(kLeastArcToleranceUm, kArcShare * 1000 * tolerance);
  for (const CurvePiece& piece : FitArcs(points, arc_um)) {
    const Eigen::Vector2d end = MicronsToMm(points[piece.last]);
    if (!piece.is_arc) {
      straight.push_back(PointOf(end));
      continue;
    }
    if (straight.size() > 1) lines();
    ArcTo({end.x(), end.y(), z}, MicronsToMm(piece.centre), piece.clockwise, feed_mm_min);
    straight = {PointOf(end)};
  }
  if (straight.size() > 1) lines();
}

}  // namespace slicefarm::milling
