#include "services/slicing/algo/placement/arranging/free_positions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/convex.h"
#include "common/geometry/predicates.h"

namespace slicefarm::slicing {
namespace {

/// Largest distance in nm by which a point computed in double may violate a limit. Up to this
/// distance, the point is still tested exactly.
constexpr double kSlack = 0.5;

/// Smallest angle of a wedge, in radians, in which a grid point is searched. In a sharper wedge,
/// even the largest step would not reach a width of one grid step.
constexpr double kSharpest = 4e-3;

Point ExtremeAgainst(const Polygon& hull, Point along) {
  // The loop finds the hull's point farthest to the right of the direction.
  Point worst = hull[0];
  for (const Point p : hull)
    if (Orientation({0, 0}, along, p - worst) < 0) worst = p;
  return worst;
}

Box Common(const Box& a, const Box& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

bool BoxHolds(const Box& box, Point p) {
  return box.min.x < p.x && p.x < box.max.x && box.min.y < p.y && p.y < box.max.y;
}

}  // namespace

FreePositions::FreePositions(const Polygon& bed, const Polygon& hull, Point target)
    : target_(target) {
  for (size_t i = 0; i < bed.size(); ++i) {
    const Point along = bed[(i + 1) % bed.size()] - bed[i];
    limits_.push_back({bed[i], along, ExtremeAgainst(hull, along)});
  }
  bed_ring_ = BedRing(bed);
  for (const Vector2& s : bed_ring_) {
    bed_box_.Add(
        Point{static_cast<Coord>(std::floor(s.x())), static_cast<Coord>(std::floor(s.y()))});
    bed_box_.Add(Point{static_cast<Coord>(std::ceil(s.x())), static_cast<Coord>(std::ceil(s.y()))});
  }
  cells_.resize(kCells * kCells);
  OfferAlong(bed_ring_);
  Offer(ToVector(target));
}

bool FreePositions::InBed(Point t) const {
  return std::all_of(limits_.begin(), limits_.end(), [t](const Limit& limit) {
    const Point at = limit.corner + t - limit.from;
    // Largest error of a double result in nm^2, for coordinates up to 2^33 nm.
    constexpr double kDoubt = 1 << 14;
    const double cross = Cross(limit.along, at);
    return cross > kDoubt || (cross > -kDoubt && Orientation({0, 0}, limit.along, at) >= 0);
  });
}

bool FreePositions::Allowed(Point t) const {
  if (t.x < bed_box_.min.x || t.x > bed_box_.max.x || t.y < bed_box_.min.y || t.y > bed_box_.max.y)
    return false;
  const std::vector<uint32_t>& near = cells_[CellOf(t.x, t.y)];
  return std::none_of(near.begin(), near.end(),
                      [&](uint32_t i) {
                        return BoxHolds(obstacles_[i].box, t) &&
                               StrictlyInside(t, obstacles_[i].ring);
                      }) &&
         InBed(t);
}

size_t FreePositions::CellOf(Coord x, Coord y) const {
  const auto index = [](Coord v, Coord min, Coord max) {
    return std::clamp<Coord>((v - min) * kCells / (max - min + 1), 0, kCells - 1);
  };
  return index(y, bed_box_.min.y, bed_box_.max.y) * kCells +
         index(x, bed_box_.min.x, bed_box_.max.x);
}

void FreePositions::Register(Polygon ring) {
  const Box box = Bounds(ring);
  std::vector<Vector2> spots;
  for (const Point p : ring) spots.push_back(ToVector(p));
  const size_t from = CellOf(box.min.x, box.min.y), to = CellOf(box.max.x, box.max.y);
  for (size_t row = from / kCells; row <= to / kCells; ++row)
    for (size_t column = from % kCells; column <= to % kCells; ++column)
      cells_[row * kCells + column].push_back(static_cast<uint32_t>(obstacles_.size()));
  obstacles_.push_back({std::move(ring), box, std::move(spots)});
}

std::vector<Vector2> FreePositions::BedRing(const Polygon& bed) const {
  // Sutherland-Hodgman clipping: starts with the bed's box, moved by one corner of the hull, and
  // cuts it by each limit.
  Box box = Bounds(bed);
  const Point corner = limits_[0].corner;
  box = {box.min - corner, box.max - corner};
  const double x0 = box.min.x, y0 = box.min.y, x1 = box.max.x, y1 = box.max.y;
  std::vector<Vector2> ring = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  for (const Limit& limit : limits_) {
    const double length = Norm(limit.along);
    const Point base = limit.from - limit.corner;
    const auto side = [&](Vector2 s) {
      return (limit.along.x * (s.y() - base.y) - limit.along.y * (s.x() - base.x)) / length;
    };
    std::vector<Vector2> kept;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vector2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double da = side(a), db = side(b);
      if (da >= -kSlack) kept.push_back(a);
      if ((da >= -kSlack) != (db >= -kSlack)) {
        const double s = da / (da - db);
        kept.push_back({a.x() + s * (b.x() - a.x()), a.y() + s * (b.y() - a.y())});
      }
    }
    ring = std::move(kept);
  }
  std::reverse(ring.begin(), ring.end());
  return ring;
}

bool FreePositions::Offer(Vector2 spot) {
  const size_t before = places_.size();
  const Coord x = static_cast<Coord>(std::floor(spot.x() / kPositionStep)) * kPositionStep;
  const Coord y = static_cast<Coord>(std::floor(spot.y() / kPositionStep)) * kPositionStep;
  for (const Point t : {Point{x, y}, Point{x + kPositionStep, y}, Point{x, y + kPositionStep},
                        Point{x + kPositionStep, y + kPositionStep}})
    if (Allowed(t)) places_.push_back(t);
  return places_.size() > before;
}

void FreePositions::OfferAlong(const std::vector<Vector2>& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], b = ring[(i + 1) % ring.size()];
    Offer(a);
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), squared = dx * dx + dy * dy;
    if (squared <= 0) continue;
    const double s = ((target_.x - a.x()) * dx + (target_.y - a.y()) * dy) / squared;
    if (s > 0 && s < 1) Offer({a.x() + s * dx, a.y() + s * dy});
  }
}

std::vector<FreePositions::Segment> FreePositions::Within(const std::vector<Vector2>& ring,
                                                          const Box& box) {
  std::vector<Segment> found;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vector2 a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (std::max(a.x(), b.x()) >= box.min.x && std::min(a.x(), b.x()) <= box.max.x &&
        std::max(a.y(), b.y()) >= box.min.y && std::min(a.y(), b.y()) <= box.max.y)
      found.push_back({a, b});
  }
  return found;
}

void FreePositions::OfferCrossing(const Segment& a, const Segment& b) {
  const double ax = a.b.x() - a.a.x(), ay = a.b.y() - a.a.y(), bx = b.b.x() - b.a.x(),
               by = b.b.y() - b.a.y();
  const double cross = ax * by - ay * bx;
  if (cross == 0) return;
  const double x = b.a.x() - a.a.x(), y = b.a.y() - a.a.y();
  const double t = (x * by - y * bx) / cross, u = (x * ay - y * ax) / cross;
  if (t < 0 || t > 1 || u < 0 || u > 1) return;
  const Vector2 spot = {a.a.x() + t * ax, a.a.y() + t * ay};
  if (Offer(spot)) return;
  // The two obstacles are to the left of their edges, so outwards is to the right of both edges.
  const double la = Hypot(ax, ay), lb = Hypot(bx, by);
  const double nx = ay / la + by / lb, ny = -ax / la - bx / lb, n = Hypot(nx, ny);
  if (n < kSharpest) return;
  for (const double step : {2e3, 1e4, 5e4, 2.5e5})
    if (Offer({spot.x() + step * nx / n, spot.y() + step * ny / n})) return;
}

void FreePositions::OfferCrossings(const std::vector<Vector2>& a, const std::vector<Vector2>& b,
                                   const Box& common) {
  const std::vector<Segment> of_b = Within(b, common);
  for (const Segment& s : Within(a, common))
    for (const Segment& other : of_b) OfferCrossing(s, other);
}

void FreePositions::AddObstacles(std::vector<Polygon> obstacles) {
  if (bed_ring_.empty()) return;
  const size_t old = obstacles_.size();
  for (Polygon& ring : obstacles) {
    std::erase_if(places_, [&](Point t) { return StrictlyInside(t, ring); });
    if (Bounds(ring).Intersects(bed_box_)) Register(std::move(ring));
  }
  for (size_t i = old; i < obstacles_.size(); ++i) {
    const Obstacle& obstacle = obstacles_[i];
    OfferAlong(obstacle.spots);
    OfferCrossings(obstacle.spots, bed_ring_, obstacle.box);
    for (size_t j = 0; j < i; ++j) {
      const Box& box = obstacles_[j].box;
      if (!box.Intersects(obstacle.box)) continue;
      OfferCrossings(obstacle.spots, obstacles_[j].spots, Common(box, obstacle.box));
    }
  }
}

}  // namespace slicefarm::slicing
