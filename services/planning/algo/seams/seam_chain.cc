#include "services/planning/algo/seams/seam_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm::planning {
namespace {

constexpr Coord kArmNm = 500'000;
constexpr double kInnerCornerMm = 0;
constexpr double kOuterCornerMm = 0.5;
constexpr double kStraightMm = 2;
/// Turns from here on count as sharp.
constexpr double kSharpRad = std::numbers::pi / 3;
/// A seam this far below is not followed: the ring starts a chain of its own.
constexpr double kReachMm = 20;
/// Bounds the work where a layer is dust: with more rings below, each ring starts a chain of its
/// own.
constexpr size_t kMaxLinks = 5000;
/// For a chain's start: how much more a corner counts than lying at the rear.
constexpr double kCornerOverRear = 20;
/// Decides between corners that are equal but for their x.
constexpr double kLeftOfEqual = 1e-6;
/// How far a chain follows a seam that is at no corner, each layer.
constexpr double kDrift = 0.1;

/// The point `kArmNm` along the ring from `vertex`, in steps of `step` (+1 or -1), to whole
/// vertices.
Point ArmEnd(const Polygon& ring, size_t vertex, size_t step) {
  const size_t n = ring.size();
  double length = 0;
  size_t i = vertex;
  do {
    const size_t next = (i + step) % n;
    length += Distance(ring[i], ring[next]);
    i = next;
  } while (length < kArmNm && i != vertex);
  return ring[i];
}

struct Candidate {
  double cost_mm = INFINITY;
  size_t vertex = 0;
};

/// The vertex with the least `cost_mm(i, best so far)`; the first of equals.
template <typename Cost>
Candidate Cheapest(const Polygon& ring, const Cost& cost_mm) {
  Candidate best;
  for (size_t i = 0; i < ring.size(); ++i) {
    const double cost = cost_mm(i, best.cost_mm);
    if (cost < best.cost_mm) best = {cost, i};
  }
  return best;
}

size_t StartOfChain(const Polygon& ring) {
  const Point rear = RearMost(ring);
  const auto cost_mm = [&](size_t i, double best_mm) {
    const double away_mm = ToMm(rear.y - ring[i].y) + kLeftOfEqual * ToMm(ring[i].x - rear.x);
    if (away_mm >= best_mm) return away_mm;
    return away_mm + kCornerOverRear * SeamPenaltyMm(ring, i);
  };
  return Cheapest(ring, cost_mm).vertex;
}

/// How far a chain at `target` goes along with a seam of this penalty.
Point Follow(Point target, Point seam, double penalty_mm) {
  const double corner = (kStraightMm - penalty_mm) / (kStraightMm - kOuterCornerMm);
  const double share = std::clamp(corner, kDrift, 1.0);
  return target + Point{std::llround(share * (seam.x - target.x)),
                        std::llround(share * (seam.y - target.y))};
}

}  // namespace

Point RearMost(const Polygon& ring) {
  return *std::min_element(ring.begin(), ring.end(), [](Point a, Point b) {
    return std::pair(-a.y, a.x) < std::pair(-b.y, b.x);
  });
}

double SeamPenaltyMm(const Polygon& ring, size_t vertex) {
  const size_t n = ring.size();
  const Point in = ring[vertex] - ArmEnd(ring, vertex, n - 1);
  const Point out = ArmEnd(ring, vertex, 1) - ring[vertex];
  const double turn = Atan2(Cross(in, out), Dot(in, out));  // > 0: a corner of the solid
  const double sharpness = std::min(std::abs(turn) / kSharpRad, 1.0);
  const double corner_mm = turn < 0 ? kInnerCornerMm : kOuterCornerMm;
  return kStraightMm + (corner_mm - kStraightMm) * sharpness;
}

std::vector<Point> SeamChain::Next(const MultiPolygon& outlines) {
  current_.clear();
  std::vector<Point> seams;
  for (const PolygonWithHoles& island : outlines) {
    seams.push_back(Place(/*hole=*/false, island.outer));
    for (const Polygon& hole : island.holes) seams.push_back(Place(/*hole=*/true, hole));
  }
  std::swap(below_, current_);
  return seams;
}

Point SeamChain::Place(bool hole, const Polygon& ring) {
  const Box box = Bounds(ring);
  Candidate best{kReachMm, 0};
  const Link* from = nullptr;
  const bool follow = below_.size() <= kMaxLinks;
  for (const Link& below : std::span(below_).first(follow ? below_.size() : 0)) {
    if (below.hole != hole || !below.box.Intersects(box)) continue;
    const auto cost_mm = [&](size_t i, double best_mm) {
      const double away_mm = ToMm(Distance(ring[i], below.target));
      if (away_mm >= std::min(best_mm, best.cost_mm)) return away_mm;
      return away_mm + SeamPenaltyMm(ring, i);
    };
    const Candidate near = Cheapest(ring, cost_mm);
    if (near.cost_mm >= best.cost_mm) continue;
    best = near;
    from = &below;
  }
  const size_t vertex = from != nullptr ? best.vertex : StartOfChain(ring);
  const Point seam = ring[vertex];
  const Point target =
      from != nullptr ? Follow(from->target, seam, SeamPenaltyMm(ring, vertex)) : seam;
  current_.push_back({hole, box, target});
  return seam;
}

}  // namespace slicefarm::planning
