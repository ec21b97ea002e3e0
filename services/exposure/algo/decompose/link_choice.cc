#include "services/exposure/algo/decompose/link_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "common/geometry/vector.h"
#include "services/exposure/algo/decompose/edge_point.h"

namespace slicefarm::exposure {
namespace {

/// Cosine of the smallest angle between a cut and an edge if the cut ends at a reflex corner. A
/// smaller angle cuts slivers off walls that are straight except for rounding. The paper has no
/// limit for reflex corners.
constexpr double kCosine1 = 0.99984769515639127;
/// Ranks of candidates, best first. The last rank is used only if no other candidate is left.
enum Rank { kBothReflex, kReflex, kConvex, kSharp };
/// Directions of a cut that ends at no corner, as shares of A's angle. They are tried in this
/// order, the bisector first.
constexpr std::array kShares = {0.5, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875, 0.0625, 0.9375};
constexpr int32_t kVariants = 3;
/// Largest difference of weights at which a cut counts as nearly as good as the best cut.
constexpr double kNearlyAsGood = 0.3;
/// Largest deviation from the tried direction, as a share of A's angle. Within it, the cut ends at
/// the point with the simplest coordinates.
constexpr double kShareTolerance = 0.04;

/// Returns true if the ray from a corner towards `to` starts inside the region. `in` and `out`: the
/// corner's edges, towards it and away from it.
bool InCone(Vector2 in, Vector2 out, Vector2 to) {
  const bool left_of_in = CrossSign(in, to) > 0;
  const bool left_of_out = CrossSign(out, to) > 0;
  return CrossSign(in, out) >= 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
}

Vector2 Unit(const Vector2& v) { return v / Norm(v); }

/// Returns the direction that divides A, the angle between `in` and -`out`, by `share`. The share
/// 1/2 gives the bisector. Other shares are approximate shares of the angle.
Vector2 Between(Vector2 in, Vector2 out, double share) {
  const Vector2 first = Unit(in), straight = Unit(out);
  // The bisector is the sum of A's sides, and also the perpendicular of P's edges. The longer of
  // the two vectors is more precise.
  Vector2 sum = first - straight;
  const Vector2 across = TurnedLeft(first + straight);
  if (Dot(across, across) > Dot(sum, sum)) sum = across;
  const Vector2 middle = sum / Norm(sum);
  const Vector2 side = share < 0.5 ? first : Vector2(-straight);
  const double toward_side = 2 * std::abs(share - 0.5);
  return middle + toward_side * (side - middle);
}

}  // namespace

void LinkChoice::AddCandidate(const Polygon& ring, CornerIndex index, Vector2 at, bool turns) {
  const Point q = ring[index.point];
  const Vector2 in = ToVector(q - Before(ring, index.point));
  const Vector2 out = ToVector(After(ring, index.point) - q);
  const Vector2 back = -at;
  if (!InCone(in, out, back)) return;
  Candidate candidate{.turns = turns, .at = at, .index = index};
  const double here_a = -CosineOf(in_, at), here_b = CosineOf(out_, at);
  const double there_a = -CosineOf(in, back), there_b = CosineOf(out, back);
  if (turns) candidate.weight = std::abs(here_a - here_b) + std::abs(there_a - there_b);
  candidate.end_cosine = std::max(there_a, there_b);
  candidate.cosine = std::max({here_a, here_b, candidate.end_cosine});
  if (CrossSign(in, out) < 0) {
    const bool both = CrossSign(in, back) >= 0 && CrossSign(out, back) >= 0;
    candidate.rank = candidate.cosine > kCosine1 ? kSharp : both ? kBothReflex : kReflex;
  } else {
    candidate.rank = candidate.end_cosine > kCosine30 ? kSharp : kConvex;
  }
  candidates_.push_back(candidate);
}

void LinkChoice::Collect(const CutRegion& region, CornerIndex from) {
  const Polygon& own = region.rings[from.ring];
  origin_ = own[from.point];
  in_ = ToVector(origin_ - Before(own, from.point));
  out_ = ToVector(After(own, from.point) - origin_);
  edges_.clear();
  candidates_.clear();
  for (size_t r = 0; r < region.rings.size(); ++r) {
    const Polygon& ring = region.rings[r];
    Vector2 before = ToVector(ring.back() - origin_);
    int before_in = CrossSign(in_, before), before_out = CrossSign(out_, before);
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vector2 at = ToVector(ring[i] - origin_);
      const int side_in = CrossSign(in_, at), side_out = CrossSign(out_, at);
      if (!(before_in < 0 && side_in < 0) && !(before_out < 0 && side_out < 0)) {
        const size_t start = i == 0 ? ring.size() - 1 : i - 1;
        edges_.push_back({before, at, CrossSign(before, at), {r, start}});
      }
      if (side_in >= 0 && side_out >= 0 && at != Vector2::Zero())
        AddCandidate(ring, {r, i}, at, side_in != 0 && side_out != 0);
      before = at;
      before_in = side_in;
      before_out = side_out;
    }
  }
}

/// Returns true if no edge crosses the segment from P to `at`, and no corner is on it.
bool LinkChoice::Sees(Vector2 at) {
  const double length2 = Dot(at, at);
  const auto on_way = [&](Vector2 u) {
    const double along = Dot(at, u);
    return along > 0 && along < length2 && u != at;
  };
  for (size_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    const int from = CrossSign(at, edge.from), to = CrossSign(at, edge.to);
    const bool blocks =
        (from == 0 && on_way(edge.from)) || (to == 0 && on_way(edge.to)) ||
        (from * to < 0 && edge.origin_side * CrossSign(edge.to - edge.from, at - edge.from) < 0);
    if (!blocks) continue;
    std::swap(edges_[i], edges_[i / 2]);  // edges that often block move to the front
    return false;
  }
  return true;
}

/// Returns a cut that divides A by `share` and ends on the first edge in this direction.
std::optional<Link> LinkChoice::LinkAlong(const CutRegion& region, double share) {
  const Vector2 path = Between(in_, out_, share);
  const Edge* hit = nullptr;
  double nearest = 0;
  for (const Edge& edge : edges_) {
    const double from = Cross(path, edge.from), to = Cross(path, edge.to);
    // The interior is to the left of an edge. So P sees only edges that cross the ray from right to
    // left.
    if (!(from <= 0 && to > 0) || edge.origin_side <= 0) continue;
    const double t = from / (from - to);
    const double distance = Dot(path, edge.from + t * (edge.to - edge.from));
    if (hit == nullptr || distance < nearest) {
      hit = &edge;
      nearest = distance;
    }
  }
  if (hit == nullptr) return std::nullopt;

  const auto share_on_hit = [&](Vector2 d, double otherwise) {
    const double from = Cross(d, hit->from), to = Cross(d, hit->to);
    return from <= 0 && to > 0 ? from / (from - to) : otherwise;
  };
  const double low = share_on_hit(Between(in_, out_, share - kShareTolerance), 0);
  const double high = share_on_hit(Between(in_, out_, share + kShareTolerance), 1);
  const Polygon& ring = region.rings[hit->index.ring];
  const Point a = ring[hit->index.point], b = After(ring, hit->index.point);
  const double middle = share_on_hit(path, 0.5);
  const double span = std::min({middle - low, high - middle, 0.9 * middle, 0.9 * (1 - middle)});
  if (!(span > 0)) return std::nullopt;
  const EdgePoint place = PointOnEdge(a, b, middle - span, middle + span);
  const Vector2 at = ToVector(place.point - origin_);
  if (place.point == a || place.point == b || at == Vector2::Zero()) return std::nullopt;
  if (CrossSign(in_, at) < 0 || CrossSign(out_, at) < 0 ||
      CrossSign(hit->to - hit->from, at - hit->from) < 0)
    return std::nullopt;
  const Vector2 edge = hit->to - hit->from;
  const double cosine =
      std::max({-CosineOf(in_, at), CosineOf(out_, at), std::abs(CosineOf(edge, at))});
  const CornerIndex index = hit->index;
  if (!Sees(at)) return std::nullopt;
  return Link{.end = index, .extra = place.point, .cosine = cosine};
}

std::optional<Link> LinkChoice::BisectorLink(const CutRegion& region, int32_t variant) {
  // The first three elements of kShares are the bisector, and a direction on either side of it.
  const auto first = static_cast<size_t>(variant);
  if (const std::optional<Link> link = LinkAlong(region, kShares[first])) return link;
  for (const double share : kShares)
    if (const std::optional<Link> link = LinkAlong(region, share)) return link;
  return std::nullopt;
}

Link LinkChoice::LinkTo(const Candidate& candidate) const {
  Link link{.end = candidate.index, .cosine = candidate.cosine};
  if (candidate.rank == kConvex) link.ruled_cosine = candidate.end_cosine;
  return link;
}

/// Returns a cut near the bisector if the best candidate is convex and no other corner is equally
/// good; otherwise the cut to the best candidate. A cut to a reflex corner is always better than
/// the bisector, because it removes another reflex corner.
Link LinkChoice::InsteadOf(const Candidate& best, const CutRegion& region, int32_t variant) {
  if (best.rank == kConvex)
    if (const std::optional<Link> link = BisectorLink(region, variant);
        link && link->cosine <= kCosine30)
      return *link;
  return LinkTo(best);
}

std::optional<Link> LinkChoice::Choose(const CutRegion& region, CornerIndex from, int32_t variant) {
  Collect(region, from);
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.Key() < b.Key(); });
  const int32_t asked = variant % kVariants;
  bool tried_bisector = false;
  int32_t seen = 0;
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates_) {
    if (best != nullptr && candidate.rank != best->rank) break;
    if (best != nullptr &&
        (candidate.cosine > kCosine30 || candidate.weight > best->weight + kNearlyAsGood))
      continue;
    if (candidate.rank == kSharp && !tried_bisector) {
      if (const std::optional<Link> link = BisectorLink(region, asked)) return link;
      tried_bisector = true;
    }
    if (!Sees(candidate.at)) continue;
    best = &candidate;
    if (seen++ == asked) return LinkTo(*best);
  }
  if (best != nullptr) return InsteadOf(*best, region, asked);
  return tried_bisector ? std::nullopt : BisectorLink(region, asked);
}

}  // namespace slicefarm::exposure
