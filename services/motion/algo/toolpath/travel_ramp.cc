#include "services/motion/algo/toolpath/travel_ramp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/base/portable_math.h"

namespace slicefarm::motion {
namespace {

constexpr double kUmPerMillimetre = 1e3;
/// Number of moves of a circle on which the nozzle rises.
constexpr int kSpiralMoves = 24;

double LengthUm(PointUm from, PointUm to) { return Hypot(to.x - from.x, to.y - from.y); }

Point ToPoint(PointUm point) { return {FromUm(point.x), FromUm(point.y)}; }

/// Returns the distance in micrometres along the travel to the first crossing of an outline at
/// which the nozzle must be at full height.
double ObstacleUm(PointUm from, std::span<const PointUm> travel, const LayerBelow& below) {
  std::vector<double> meets;
  double gone = 0;
  PointUm last = from;
  for (const PointUm next : travel) {
    const double length = LengthUm(last, next);
    for (const double share : below.EdgesOn(ToPoint(last), ToPoint(next)))
      meets.push_back(gone + share * length);
    gone += length;
    last = next;
  }
  const size_t own = below.Covers(ToPoint(from)) ? 1 : 0;
  return meets.size() > own ? meets[own] : std::numeric_limits<double>::infinity();
}

PointUm Between(PointUm from, PointUm to, double share) {
  return {from.x + static_cast<int32_t>(std::lround(share * (to.x - from.x))),
          from.y + static_cast<int32_t>(std::lround(share * (to.y - from.y)))};
}

}  // namespace

double LiftOf(const RetractionOptions& retraction) {
  return retraction.ramping ? retraction.ramp_lift_mm : retraction.lift_mm;
}

bool RisesAlongTravel(const RetractionOptions& retraction) {
  return retraction.ramping && retraction.ramp_slope_deg > 0 && retraction.ramp_slope_deg < 90;
}

std::vector<RampPoint> SpiralledTravel(PointUm from, std::span<const PointUm> travel,
                                       const RetractionOptions& retraction) {
  const double lift_um = retraction.ramp_lift_mm * kUmPerMillimetre;
  const double slope = Tan(retraction.ramp_slope_deg * std::numbers::pi / 180);
  const double radius_um = lift_um / slope / (2 * std::numbers::pi);
  const PointUm to = travel.front();
  const double length = LengthUm(from, to);
  const auto up_um = static_cast<int32_t>(std::lround(lift_um));
  std::vector<RampPoint> points;
  // The circle begins and ends in the direction of the travel.
  const double x = length > 0 ? (to.x - from.x) / length : 1;
  const double y = length > 0 ? (to.y - from.y) / length : 0;
  for (int i = 1; i < kSpiralMoves; ++i) {
    const double share = static_cast<double>(i) / kSpiralMoves;
    const double angle = 2 * std::numbers::pi * share;
    const double along = radius_um * Sin(angle), aside = radius_um * (1 - Cos(angle));
    const PointUm point{from.x + static_cast<int32_t>(std::lround(along * x - aside * y)),
                        from.y + static_cast<int32_t>(std::lround(along * y + aside * x))};
    points.push_back({point, static_cast<int32_t>(std::lround(share * lift_um))});
  }
  points.push_back({from, up_um});
  for (const PointUm next : travel) points.push_back({next, up_um});
  return points;
}

std::vector<RampPoint> RampedTravel(PointUm from, std::span<const PointUm> travel,
                                    const RetractionOptions& retraction, const LayerBelow* below) {
  const double lift_um = retraction.ramp_lift_mm * kUmPerMillimetre;
  double ramp_um = lift_um / Tan(retraction.ramp_slope_deg * std::numbers::pi / 180);
  if (retraction.before_obstacles && below != nullptr)
    ramp_um = std::min(ramp_um, ObstacleUm(from, travel, *below));
  const auto up = [&](double gone_um) {
    return static_cast<int32_t>(
        std::lround(gone_um >= ramp_um ? lift_um : gone_um / ramp_um * lift_um));
  };
  std::vector<RampPoint> points;
  if (ramp_um < 1) points.push_back({from, up(ramp_um)});
  double gone = 0;
  PointUm last = from;
  for (const PointUm next : travel) {
    const double length = LengthUm(last, next);
    if (gone < ramp_um && ramp_um < gone + length)
      if (const PointUm end = Between(last, next, (ramp_um - gone) / length);
          end != last && end != next)
        points.push_back({end, up(ramp_um)});
    gone += length;
    points.push_back({next, up(gone)});
    last = next;
  }
  return points;
}

}  // namespace slicefarm::motion
