#include "services/exposure/algo/scan/corner_spurs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "common/base/portable_math.h"

namespace slicefarm::exposure {
namespace {

/// Narrower tips stay open, as a share of the spot.
constexpr double kOpenTip = 0.25;
/// Sine of half of the bluntest angle with a spur: it leaves a tenth of a spot's width open.
constexpr double kBluntest = 0.83;
/// Pieces lie this close to the region's border, as it is simplified before it is cut.
constexpr double kSpurTouchNm = 3'000;
/// A spur along the border is as far from it as its ring, but for what rounding does; its ring may
/// be nearer by what simplifying has moved.
constexpr double kRoundingNm = 500;
constexpr double kSimplifiedNm = 2'000;

struct SharpCorner {
  Vector2 at = Vector2::Zero();
  Vector2 in = Vector2::Zero(), out = Vector2::Zero();  ///< directions of its sides, of length 1
  Vector2 outward = Vector2::Zero();                    ///< of the bisector
  double sine = 0, cosine = 0;                          ///< of half of its angle

  /// From a tip of the same angle along the bisector to where it is too wide to stay open.
  double OpenNm(const SpurFill& fill) const {
    return std::max(fill.spot_nm / 2, kOpenTip / 2 * fill.spot_nm * cosine / sine);
  }
};

Vector2 UnitBetween(Vector2 a, Vector2 b) {
  const Vector2 way = b - a;
  const double length = Norm(way);
  return length > 0 ? Vector2{way.x() / length, way.y() / length} : Vector2(Vector2::Zero());
}

Vector2 Along(Vector2 from, Vector2 way, double length) {
  return {from.x() + length * way.x(), from.y() + length * way.y()};
}

/// nullopt: the corner is blunt, or no corner at all.
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
  Vector2 way = Vector2::Zero();  ///< of length 1
  double length = 0;
};

/// The ring with what `spur_of` says of its sharp corners.
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
    result.push_back(Along(ring[i], spur.way, spur.length));
    result.push_back(ring[i]);
  }
  return result;
}

/// How far it is from `p`, inside a convex ring, along `way` to the ring.
double DistanceTo(const ConvexRing& ring, Vector2 p, Vector2 way) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double out = Cross(way, edge);
    if (out > 0) nearest = std::min(nearest, Cross(edge, p - a) / out);
  }
  return nearest;
}

/// Of a convex ring at `p`, across `way`.
double WidthAt(const ConvexRing& ring, Vector2 p, Vector2 way) {
  return DistanceTo(ring, p, {way.y(), -way.x()}) + DistanceTo(ring, p, {-way.y(), way.x()});
}

}  // namespace

ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill) {
  return Spurred(ring, fill, [&](const SharpCorner& corner) {
    const double to_tip = DistanceTo(around, corner.at, corner.outward);
    const Spur spur{corner.outward, to_tip - fill.spot_nm / 2};
    // Where a side of the gap has gone in the ring, the gap need not taper as the ring does.
    const double width = WidthAt(around, Along(corner.at, spur.way, spur.length), spur.way);
    return width < kOpenTip * fill.spot_nm ? Spur{spur.way, to_tip - corner.OpenNm(fill)} : spur;
  });
}

double OpenShare(const ConvexRing& piece, double pitch_nm, const SpurFill& fill) {
  const double radius = fill.spot_nm / 2;
  double open_nm2 = 0, around_nm = 0;
  for (size_t i = 0; i < piece.size(); ++i) {
    around_nm += Norm(piece[(i + 1) % piece.size()] - piece[i]);
    const std::optional<SharpCorner> corner = SharpCornerOf(piece, i);
    if (!corner) continue;
    // Between both sides of the tip and the spot that touches them.
    const double half = Atan2(corner->sine, corner->cosine);
    open_nm2 += radius * radius * (corner->cosine / corner->sine - std::numbers::pi / 2 + half);
  }
  // A piece has no more than 2 * area / (length around it * pitch) rings.
  return around_nm > 0 ? 2 * open_nm2 / (around_nm * pitch_nm) : 0;
}

double SpurReach(double gap_nm) { return std::max(gap_nm, kSpurTouchNm); }

ConvexRing WithOuterSpurs(const ConvexRing& ring, double gap_nm, const BorderGrid& border,
                          const SpurFill& fill) {
  // Whether a side of the piece is the region's border: at the foot of the corner on it.
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
      // To the cut; at a right angle half of the way, as the spur beyond the cut does the same.
      const double sine = 2 * corner.sine * corner.cosine;
      const Vector2 back{-corner.out.x(), -corner.out.y()};
      spur = {in_border ? corner.in : back, gap_nm / sine - gap_nm / 2 * sine};
    }
    spur.length = std::min(spur.length, kLongestSpur * gap_nm);
    // It may come near to the border beside the cuts, on its way too.
    const double least = std::max(fill.least_nm, kSpurTouchNm);
    for (; spur.length > least; spur.length *= 0.7) {
      const Vector2 tip = Along(corner.at, spur.way, spur.length);
      if (keeps(tip, tip, kRoundingNm) && keeps(corner.at, tip, kSimplifiedNm)) return spur;
    }
    return Spur{};
  });
}

}  // namespace slicefarm::exposure
