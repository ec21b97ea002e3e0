#include "services/exposure/algo/scan/corner_spurs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "common/base/portable_math.h"

namespace slicefarm::exposure {
namespace {

/// Largest width of a tip that stays unmelted, as a share of the spot.
constexpr double kOpenTip = 0.25;
/// Sine of half of the largest angle of a corner with a spur. A corner of this angle without a spur
/// leaves a tip of a tenth of a spot unmelted.
constexpr double kBluntest = 0.83;
/// Largest distance between a side of a piece and the region's boundary at which they count as the
/// same. The boundary is simplified before the region is cut into pieces.
constexpr double kSpurTouchNm = 3'000;
/// Tolerances of a spur's distance from the boundary. A spur along the boundary keeps the ring's
/// distance except for rounding (first value). The ring itself may be nearer by the second value,
/// because simplification moves the boundary.
constexpr double kRoundingNm = 500;
constexpr double kSimplifiedNm = 2'000;

struct SharpCorner {
  Vector2 at = Vector2::Zero();
  Vector2 in = Vector2::Zero(), out = Vector2::Zero();  ///< unit vectors of its sides
  Vector2 outward = Vector2::Zero();                    ///< unit vector of the bisector, outwards
  double sine = 0, cosine = 0;                          ///< sine and cosine of half of its angle

  /// Returns the distance along the bisector, from the tip, at which the gap becomes wider than
  /// kOpenTip permits.
  double OpenNm(const SpurFill& fill) const {
    return std::max(fill.spot_nm / 2, kOpenTip / 2 * fill.spot_nm * cosine / sine);
  }
};

Vector2 UnitBetween(Vector2 a, Vector2 b) {
  const Vector2 direction = b - a;
  const double length = Norm(direction);
  return length > 0 ? Vector2{direction.x() / length, direction.y() / length}
                    : Vector2(Vector2::Zero());
}

Vector2 Along(Vector2 from, Vector2 direction, double length) {
  return {from.x() + length * direction.x(), from.y() + length * direction.y()};
}

/// Returns the sharp corner at point i, or nullopt if the corner is blunt or not a corner at all.
std::optional<SharpCorner> SharpCornerOf(const ConvexRing& ring, size_t i) {
  SharpCorner corner;
  corner.at = ring[i];
  corner.in = UnitBetween(ring[i == 0 ? ring.size() - 1 : i - 1], corner.at);
  corner.out = UnitBetween(corner.at, ring[(i + 1) % ring.size()]);
  const Vector2 outward = corner.in - corner.out;
  corner.cosine = Norm(outward) / 2;
  corner.sine = std::sqrt(std::max(0.0, 1 - corner.cosine * corner.cosine));
  if (corner.sine > kBluntest || !(corner.sine > 0)) return std::nullopt;
  corner.outward = {outward.x() / (2 * corner.cosine), outward.y() / (2 * corner.cosine)};
  return corner;
}

struct Spur {
  Vector2 direction = Vector2::Zero();  ///< unit vector
  double length = 0;
};

/// Returns the ring with the spur that `spur_of` returns for each sharp corner.
template <typename SpurOf>
ConvexRing Spurred(const ConvexRing& ring, const SpurFill& fill, SpurOf spur_of) {
  ConvexRing result;
  result.reserve(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    result.push_back(ring[i]);
    const std::optional<SharpCorner> corner = SharpCornerOf(ring, i);
    if (!corner) continue;
    const Spur spur = spur_of(*corner);
    if (!(spur.length > fill.least_nm) || !std::isfinite(spur.length)) continue;
    result.push_back(Along(ring[i], spur.direction, spur.length));
    result.push_back(ring[i]);
  }
  return result;
}

/// Returns the distance from `p`, inside a convex ring, to the ring, along `direction`.
double DistanceTo(const ConvexRing& ring, Vector2 p, Vector2 direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double out = Cross(direction, edge);
    if (out > 0) nearest = std::min(nearest, Cross(edge, p - a) / out);
  }
  return nearest;
}

/// Returns the width of a convex ring at `p`, perpendicular to `direction`.
double WidthAt(const ConvexRing& ring, Vector2 p, Vector2 direction) {
  return DistanceTo(ring, p, {direction.y(), -direction.x()}) +
         DistanceTo(ring, p, {-direction.y(), direction.x()});
}

}  // namespace

ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill) {
  return Spurred(ring, fill, [&](const SharpCorner& corner) {
    const double to_tip = DistanceTo(around, corner.at, corner.outward);
    const Spur spur{corner.outward, to_tip - fill.spot_nm / 2};
    // If a side of the gap is missing in the ring, the gap may taper less than the ring's corner.
    // Then the gap's width decides.
    const double width =
        WidthAt(around, Along(corner.at, spur.direction, spur.length), spur.direction);
    return width < kOpenTip * fill.spot_nm ? Spur{spur.direction, to_tip - corner.OpenNm(fill)}
                                           : spur;
  });
}

double OpenShare(const ConvexRing& piece, double pitch_nm, const SpurFill& fill) {
  const double radius = fill.spot_nm / 2;
  double open_nm2 = 0, around_nm = 0;
  for (size_t i = 0; i < piece.size(); ++i) {
    around_nm += Norm(piece[(i + 1) % piece.size()] - piece[i]);
    const std::optional<SharpCorner> corner = SharpCornerOf(piece, i);
    if (!corner) continue;
    // Adds the area between the two sides of the tip and the spot that touches both.
    const double half = Atan2(corner->sine, corner->cosine);
    open_nm2 += radius * radius * (corner->cosine / corner->sine - std::numbers::pi / 2 + half);
  }
  // A piece has at most 2 * area / (perimeter * pitch) rings.
  return around_nm > 0 ? 2 * open_nm2 / (around_nm * pitch_nm) : 0;
}

double SpurReach(double gap_nm) { return std::max(gap_nm, kSpurTouchNm); }

ConvexRing WithOuterSpurs(const ConvexRing& ring, double gap_nm, const BorderGrid& border,
                          const SpurFill& fill) {
  // Returns true if a side of the piece is on the region's boundary: the point beside the ring's
  // corner on this side is near the boundary.
  const auto is_border = [&](Vector2 corner, Vector2 side) {
    return border.IsNear(RoundedPoint(Along(corner, {side.y(), -side.x()}, gap_nm)), kSpurTouchNm);
  };
  const auto keeps = [&](Vector2 from, Vector2 to, double less_nm) {
    return border.Keeps(RoundedPoint(from), RoundedPoint(to), std::max(0.0, gap_nm - less_nm));
  };
  return Spurred(ring, fill, [&](const SharpCorner& corner) {
    const bool in_border = is_border(corner.at, corner.in);
    const bool out_border = is_border(corner.at, corner.out);
    if (in_border && out_border) return Spur{};
    Spur spur{corner.outward, gap_nm / corner.sine - corner.OpenNm(fill)};
    if (in_border || out_border) {
      // The spur ends at the cut. At a right angle it ends halfway, because a spur on the other
      // side of the cut melts the other half.
      const double sine = 2 * corner.sine * corner.cosine;
      const Vector2 back{-corner.out.x(), -corner.out.y()};
      spur = {in_border ? corner.in : back, gap_nm / sine - gap_nm / 2 * sine};
    }
    spur.length = std::min(spur.length, kLongestSpur * gap_nm);
    // The spur is shortened until it keeps its distance from the boundary beside the cuts,
    // everywhere along its length.
    const double least = std::max(fill.least_nm, kSpurTouchNm);
    for (; spur.length > least; spur.length *= 0.7) {
      const Vector2 tip = Along(corner.at, spur.direction, spur.length);
      if (keeps(tip, tip, kRoundingNm) && keeps(corner.at, tip, kSimplifiedNm)) return spur;
    }
    return Spur{};
  });
}

}  // namespace slicefarm::exposure
