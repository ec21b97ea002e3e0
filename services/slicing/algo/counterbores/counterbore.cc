#include "services/slicing/algo/counterbores/counterbore.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/vector.h"

namespace slicefarm::slicing {
namespace {

/// Width of the ring of air below that a hole must have around it: about one bead. A bead in this
/// ring would be mostly over air.
constexpr Coord kRimNm = 400'000;
/// Distance beyond the end of a bridge at which the layer below must support it.
constexpr double kBeyondNm = 20'000;
constexpr int kDirections = 12;

Point ToPoint(const Vector2& v) { return {std::llround(v.x()), std::llround(v.y())}; }

/// Stripe along a direction. It is as wide as a ring (such as a hole) across this direction.
struct Stripe {
  Vector2 along;
  /// Limit towards the right, measured along `along` turned left.
  double right = std::numeric_limits<double>::max();
  double left = std::numeric_limits<double>::lowest();
};

Stripe StripeOf(const Polygon& ring, const Vector2& along) {
  Stripe stripe{along};
  for (const Point p : ring) {
    const double across = Dot(ToVector(p), TurnedLeft(along));
    stripe.right = std::min(stripe.right, across);
    stripe.left = std::max(stripe.left, across);
  }
  return stripe;
}

/// Returns the part of a stripe from `reach_nm` before `middle` to `reach_nm` behind it.
MultiPolygon AreaOf(const Stripe& stripe, const Vector2& middle, double reach_nm) {
  const Vector2 across = TurnedLeft(stripe.along);
  const double at = Dot(middle, stripe.along);
  const auto corner = [&](double ahead, double aside) {
    return ToPoint((at + ahead) * stripe.along + aside * across);
  };
  return {{{corner(-reach_nm, stripe.right), corner(reach_nm, stripe.right),
            corner(reach_nm, stripe.left), corner(-reach_nm, stripe.left)},
           {}}};
}

/// Unsupported part of an island, together with the holes in that part.
class Recess {
 public:
  Recess(const PolygonWithHoles& air, const MultiPolygon& below) : air_(air), below_(below) {
    const Box box = Bounds(air.outer);
    reach_nm_ = 2 * (ToVector(box.max) - ToVector(box.min)).norm();
  }

  void Add(Polygon hole) { holes_.push_back(std::move(hole)); }

  std::optional<Counterbore> Bridged() const {
    if (holes_.empty()) return std::nullopt;
    const std::optional<Vector2> along = BestDirection();
    if (!along) return std::nullopt;
    const Vector2 across = TurnedLeft(*along);
    const double half = std::numbers::sqrt2 / 2;
    Counterbore bridged;
    for (const Polygon& hole : holes_) bridged.holes.push_back({hole, {}});
    bridged.open_areas.push_back(Crossed({air_}, {*along}));
    bridged.open_areas.push_back(Crossed({air_}, {*along, across}));
    if (!Difference(bridged.open_areas.back(), FastOffset(bridged.holes, kRimNm)).empty())
      bridged.open_areas.push_back(
          Crossed({air_}, {*along, across, half * (*along + across), half * (*along - across)}));
    return bridged;
  }

 private:
  /// Returns the parts of `area` that contain a hole and are inside this hole's stripes in all
  /// directions of `paths`.
  MultiPolygon Crossed(const MultiPolygon& area, const std::vector<Vector2>& paths) const {
    MultiPolygon all;
    for (const Polygon& hole : holes_) {
      MultiPolygon open = area;
      for (const Vector2& path : paths)
        open = Intersection(open, AreaOf(StripeOf(hole, path), ToVector(hole.front()), reach_nm_));
      std::erase_if(open, [&](const auto& part) {
        return Intersection({part}, {{hole, {}}}).empty();
      });
      all.insert(all.end(), open.begin(), open.end());
    }
    return Union(Rings(all), FillRule::kNonZero);
  }

  /// Returns the bridging direction for which the crossed stripes are closest around the holes. So
  /// the layers above have the least left to bridge. Among directions within 1 %, the one with the
  /// shortest bridges wins.
  std::optional<Vector2> BestDirection() const {
    constexpr double kAlike = 1.01;
    std::optional<Vector2> best;
    double closest = 0, shortest = 0;
    for (const Polygon& edges : {air_.outer, holes_.front()})
      for (int i = 0; i < kDirections; ++i) {
        const Vector2 path =
            Eigen::Rotation2Dd(std::numbers::pi * i / kDirections) * LongestEdge(edges);
        const std::optional<double> span = LongestSpan(path);
        if (!span) continue;
        const double area = CrossedArea(path);
        if (best && area * kAlike > closest && (area > closest * kAlike || *span >= shortest))
          continue;
        best = path;
        closest = area;
        shortest = *span;
      }
    return best;
  }

  static Vector2 LongestEdge(const Polygon& ring) {
    Vector2 longest{0, 0};
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vector2 edge = ToVector(ring[(i + 1) % ring.size()]) - ToVector(ring[i]);
      if (edge.norm() > longest.norm()) longest = edge;
    }
    return longest.normalized();
  }

  double CrossedArea(const Vector2& path) const {
    double area = 0;
    for (const Polygon& hole : holes_) {
      const Stripe one = StripeOf(hole, path), other = StripeOf(hole, TurnedLeft(path));
      area += (one.left - one.right) * (other.left - other.right);
    }
    return area;
  }

  std::optional<double> LongestSpan(const Vector2& along) const {
    double longest = 0;
    for (const Polygon& hole : holes_) {
      const Stripe stripe = StripeOf(hole, along);
      const double at = Dot(ToVector(Centroid(hole)), along);
      for (const double aside : {stripe.left + kRimNm / 2.0, stripe.right - kRimNm / 2.0}) {
        const std::optional<double> span = SpanAt(along, at, aside);
        if (!span) return std::nullopt;
        longest = std::max(longest, *span);
      }
    }
    return longest;
  }

  /// Returns the length of the bridge along `along` through a point. The point's coordinates are
  /// `at` along this direction and `aside` across it. Returns nothing if one end of the bridge is
  /// not supported.
  std::optional<double> SpanAt(const Vector2& along, double at, double aside) const {
    const Vector2 across = TurnedLeft(along);
    if (Locate(ToPoint(at * along + aside * across), air_) == Side::kOutside) return std::nullopt;
    double from = std::numeric_limits<double>::lowest();
    double to = std::numeric_limits<double>::max();
    ForEachRing({air_}, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vector2 a = ToVector(ring[i]), b = ToVector(ring[(i + 1) % ring.size()]);
        const double a_aside = Dot(a, across) - aside, b_aside = Dot(b, across) - aside;
        if ((a_aside < 0) == (b_aside < 0)) continue;
        const double share = a_aside / (a_aside - b_aside);
        const double ahead = Dot(a, along) + share * (Dot(b, along) - Dot(a, along));
        (ahead < at ? from : to) = ahead < at ? std::max(from, ahead) : std::min(to, ahead);
      }
    });
    for (const double end : {from - kBeyondNm, to + kBeyondNm})
      if (!Covers(below_, ToPoint(end * along + aside * across))) return std::nullopt;
    return to - from;
  }

  const PolygonWithHoles& air_;
  const MultiPolygon& below_;
  double reach_nm_ = 0;
  std::vector<Polygon> holes_;
};

/// Returns the holes of an island that have only air below their surroundings.
std::vector<Polygon> HolesOverAir(const MultiPolygon& below, const PolygonWithHoles& island) {
  std::vector<Polygon> holes;
  for (const Polygon& ring : island.holes) {
    Polygon hole(ring.rbegin(), ring.rend());
    const MultiPolygon with_rim = FastOffset({{hole, {}}}, kRimNm);
    if (Difference(with_rim, {{island.outer, {}}}).empty() && Intersection(with_rim, below).empty())
      holes.push_back(std::move(hole));
  }
  return holes;
}

void AddCounterbores(const MultiPolygon& below, const PolygonWithHoles& island,
                     std::vector<Counterbore>& found) {
  const std::vector<Polygon> holes = HolesOverAir(below, island);
  if (holes.empty()) return;
  const MultiPolygon bored = Union({island}, Union(holes, FillRule::kNonZero));
  for (const PolygonWithHoles& air : Difference(bored, below)) {
    Recess recess(air, below);
    for (const Polygon& hole : holes)
      if (Locate(hole.front(), air) != Side::kOutside) recess.Add(hole);
    if (std::optional<Counterbore> bridged = recess.Bridged()) found.push_back(*std::move(bridged));
  }
}

}  // namespace

std::vector<Counterbore> CounterboresOver(const MultiPolygon& below, const MultiPolygon& here) {
  if (below == here || FastOffset(Difference(here, below), -kRimNm / 4).empty()) return {};
  std::vector<Counterbore> found;
  for (const PolygonWithHoles& island : here)
    if (!island.holes.empty()) AddCounterbores(below, island, found);
  return found;
}

}  // namespace slicefarm::slicing
