#include "services/exposure/algo/scan/corner_spurs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm::exposure {
namespace {

/// As a share of the spot: half of what a tip's width may be where it stays open.
constexpr double kOpenTip = 0.125;
/// Sine of half of the bluntest angle with a spur: it leaves a tenth of a spot's width open.
constexpr double kBluntest = 0.83;

PlaneVector UnitBetween(PlaneVector a, PlaneVector b) {
  const PlaneVector way = b - a;
  const double length = Norm(way);
  return length > 0 ? PlaneVector{way.x / length, way.y / length} : PlaneVector{};
}

/// How far it is from `p`, inside a convex ring, along the unit vector `way` to the ring.
double DistanceTo(const ConvexRing& ring, PlaneVector p, PlaneVector way) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    const PlaneVector a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double out = Cross(way, edge);
    if (out > 0) nearest = std::min(nearest, Cross(p - a, edge) / -out);
  }
  return nearest;
}

}  // namespace

ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill) {
  const double reach = fill.spot_nm / 2;
  ConvexRing result;
  result.reserve(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const PlaneVector p = ring[i];
    result.push_back(p);
    const PlaneVector in = UnitBetween(ring[i == 0 ? ring.size() - 1 : i - 1], p);
    const PlaneVector out = UnitBetween(p, ring[(i + 1) % ring.size()]);
    const PlaneVector bisector = in - out;
    const double norm = Norm(bisector);  // twice the cosine of half the angle
    const double sine = std::sqrt(std::max(0.0, 1 - norm * norm / 4));
    if (sine > kBluntest) continue;
    const PlaneVector way{bisector.x / norm, bisector.y / norm};
    const double open = sine > 0 ? kOpenTip * fill.spot_nm * (norm / 2) / sine : 0;
    const double length = DistanceTo(around, p, way) - std::max(reach, open);
    if (!(length > fill.least_nm) || !std::isfinite(length)) continue;
    result.push_back({p.x + length * way.x, p.y + length * way.y});
    result.push_back(p);
  }
  return result;
}

}  // namespace slicefarm::exposure
