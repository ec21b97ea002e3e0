#include "common/geometry/boolean/arrangement.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "common/geometry/boolean/near_edges.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"

namespace slicefarm::internal {
namespace {

/// Distance below which the order of two points is uncertain.
constexpr double kDoubtNm = 0.5;
/// Maximum number of edges that all rays from the starts of rings may test; about a tenth of a
/// second.
constexpr int64_t kMostLooks = 100'000'000;

/// Crossing of two edges, stored once for each of the two edges.
struct EdgeCrossing {
  int32_t ring = 0;
  int32_t edge = 0;
  double along_nm = 0;  ///< distance from the edge's start
  int32_t change = 0;   ///< change of the winding number to the left of the ring at the crossing
  int32_t crossing = 0;
  int32_t winding = 0;  ///< winding number to the left of the ring's part after the crossing
  bool used = false;

  friend bool operator<(const EdgeCrossing& a, const EdgeCrossing& b) {
    if (a.ring != b.ring) return a.ring < b.ring;
    return a.edge != b.edge ? a.edge < b.edge : a.along_nm < b.along_nm;
  }
};

struct Crossing {
  Point place;
  int32_t edge_crossings[2] = {0, 0};
};

class Arrangement {
 public:
  Arrangement(std::span<const GroupedRing> rings, int least) : rings_(rings), least_(least) {}

  std::optional<MultiPolygon> Region() {
    if (!FindRings()) return std::nullopt;
    return Assemble();
  }

  std::optional<std::vector<TracedRing>> TracedRings() {
    keeps_edges_ = true;
    if (!FindRings()) return std::nullopt;
    return std::move(result_);
  }

 private:
  bool FindRings() {
    if (!CollectEdges() || !FindCrossings() || !SortEdgeCrossings()) return false;
    for (size_t ring = 0; ring < rings_.size(); ++ring)
      if (!CountAlong(static_cast<int32_t>(ring))) return false;
    return Trace();
  }

  const Polygon& Points(int32_t ring) const { return rings_[ring].points; }

  bool CollectEdges() {
    size_t count = 0;
    for (const GroupedRing& ring : rings_) {
      if (ring.points.size() < 3) return false;
      count += ring.points.size();
    }
    edges_.reserve(count);
    for (size_t i = 0; i < rings_.size(); ++i) AppendRing(static_cast<int32_t>(i));
    return std::none_of(edges_.begin(), edges_.end(),
                        [](const BoxedEdge& edge) { return edge.from == edge.to; });
  }

  void AppendRing(int32_t ring) {
    edge_begin_.push_back(edges_.size());
    boxes_.push_back(Bounds(Points(ring)));
    AppendBoxedEdges(Points(ring), ring, edges_);
  }

  bool FindCrossings() {
    const std::span<const BoxedEdge> all = edges_;
    if (const size_t first = FirstOfTwoGroups(); first > 0)
      return ForEachNearPair(
          all.first(first), all.subspan(first),
          [this](const BoxedEdge& e, const BoxedEdge& f) { return NoteCrossing(e, f); });
    return ForEachNearPair(all, [this](const BoxedEdge& e, const BoxedEdge& f) {
      const int group = rings_[e.ring].group;
      if (group != GroupedRing::kMayMeetAny && group == rings_[f.ring].group) return true;
      return NoteCrossing(e, f);
    });
  }

  /// Returns the number of edges of the first group if the rings are of exactly two groups, one
  /// after the other, like the operands of a boolean operation. Otherwise returns 0.
  size_t FirstOfTwoGroups() const {
    size_t first = 0;
    while (first < rings_.size() && rings_[first].group == rings_[0].group) ++first;
    if (first == rings_.size() || rings_[0].group == GroupedRing::kMayMeetAny) return 0;
    const int second = rings_[first].group;
    for (size_t i = first; i < rings_.size(); ++i)
      if (rings_[i].group != second || second == GroupedRing::kMayMeetAny) return 0;
    return edge_begin_[first];
  }

  /// Returns true if f follows e at a corner of a ring.
  bool Follows(const BoxedEdge& e, const BoxedEdge& f) const {
    if (e.ring != f.ring) return false;
    const auto size = static_cast<int32_t>(Points(e.ring).size());
    return (e.index + 1) % size == f.index;
  }

  /// Records the crossing of e and f. Returns false if they touch.
  bool NoteCrossing(const BoxedEdge& e, const BoxedEdge& f) {
    const int f_from = Orientation(e.from, e.to, f.from), f_to = Orientation(e.from, e.to, f.to);
    if (Follows(e, f)) return f_to != 0 || Dot(e.to - e.from, f.to - f.from) > 0;
    if (Follows(f, e)) return f_from != 0 || Dot(e.to - e.from, f.to - f.from) > 0;
    if (f_from * f_to > 0) return true;
    const int e_from = Orientation(f.from, f.to, e.from), e_to = Orientation(f.from, f.to, e.to);
    if (e_from * e_to > 0) return true;
    if (f_from == 0 || f_to == 0 || e_from == 0 || e_to == 0) return false;
    const Point de = e.to - e.from, df = f.to - f.from, between = f.from - e.from;
    const double denominator = Cross(de, df);
    const double t = Cross(between, df) / denominator, s = Cross(between, de) / denominator;
    const auto crossing = static_cast<int32_t>(crossings_.size());
    crossings_.push_back({e.from + Point{std::llround(t * static_cast<double>(de.x)),
                                         std::llround(t * static_cast<double>(de.y))}});
    // The winding number is one greater to the left of f than to the right.
    edge_crossings_.push_back({e.ring, e.index, t * Norm(de), f_to > 0 ? -1 : 1, crossing});
    edge_crossings_.push_back({f.ring, f.index, s * Norm(df), e_to > 0 ? -1 : 1, crossing});
    return true;
  }

  bool SortEdgeCrossings() {
    std::sort(edge_crossings_.begin(), edge_crossings_.end());
    ring_begin_.assign(rings_.size() + 1, 0);
    std::vector<int> seen(crossings_.size(), 0);
    for (size_t i = 0; i < edge_crossings_.size(); ++i) {
      const EdgeCrossing& here = edge_crossings_[i];
      ++ring_begin_[here.ring + 1];
      crossings_[here.crossing].edge_crossings[seen[here.crossing]++] = static_cast<int32_t>(i);
      if (i == 0) continue;
      const EdgeCrossing& before = edge_crossings_[i - 1];
      if (before.ring == here.ring && before.edge == here.edge &&
          here.along_nm - before.along_nm < kDoubtNm) {
        return false;
      }
    }
    for (size_t ring = 0; ring < rings_.size(); ++ring) ring_begin_[ring + 1] += ring_begin_[ring];
    return true;
  }

  /// Sets the winding numbers along a ring. Returns false if they are uncertain.
  bool CountAlong(int32_t ring) {
    const int32_t begin = ring_begin_[ring], end = ring_begin_[ring + 1];
    const std::optional<int> at_start = WindingAtStart(ring);
    if (!at_start) return false;
    whole_winding_.push_back(*at_start);
    int winding = *at_start;
    for (int32_t i = begin; i < end; ++i)
      edge_crossings_[i].winding = winding += edge_crossings_[i].change;
    return winding == *at_start;
  }

  /// Returns the winding number to the left of a ring's first edge, at its start.
  std::optional<int> WindingAtStart(int32_t ring) {
    // A horizontal ray along a horizontal edge has no clear crossings. Therefore the ray starts
    // from the first edge that rises or falls, and the changes at crossings before it are
    // subtracted.
    const Polygon& points = Points(ring);
    const auto size = static_cast<int32_t>(points.size());
    const auto next = [&](int32_t i) { return i + 1 == size ? 0 : i + 1; };
    int32_t edge = 0;
    while (edge < size && points[edge].y == points[next(edge)].y) ++edge;
    if (edge == size) return std::nullopt;
    int winding = 0;
    double limit = Distance(points[edge], points[next(edge)]);
    const double length = limit;
    for (int32_t i = ring_begin_[ring]; i < ring_begin_[ring + 1]; ++i) {
      if (edge_crossings_[i].edge < edge) winding -= edge_crossings_[i].change;
      if (edge_crossings_[i].edge == edge) limit = std::min(limit, edge_crossings_[i].along_nm);
    }
    const Point from = points[edge], d = points[next(edge)] - from;
    const double t = limit / 2 / length;
    const std::optional<int> seen =
        WindingSeenFrom(static_cast<double>(from.x) + t * static_cast<double>(d.x),
                        static_cast<double>(from.y) + t * static_cast<double>(d.y), ring, edge);
    if (!seen) return std::nullopt;
    // The ray runs to the right and leaves a rising edge on its right side. The winding number to
    // the left of this edge is one greater.
    return winding + *seen + (d.y > 0 ? 1 : 0);
  }

  /// Returns true if a horizontal ray from (x, y) to the right may meet an object within the box
  /// from `min` to `max`.
  static bool MaySee(double x, double y, Point min, Point max) {
    return static_cast<double>(min.y) <= y && static_cast<double>(max.y) > y &&
           static_cast<double>(max.x) >= x;
  }

  /// Returns the winding number at (x, y), a point on edge number `but` of `ring`, from all other
  /// edges. Returns nullopt if the number is uncertain, or if too many edges were tested.
  std::optional<int> WindingSeenFrom(double x, double y, int32_t ring, int32_t but) {
    int winding = 0;
    for (size_t other = 0; other < rings_.size(); ++other) {
      if (!MaySee(x, y, boxes_[other].min, boxes_[other].max)) continue;
      const size_t count = rings_[other].points.size();
      if ((looks_left_ -= static_cast<int64_t>(count)) < 0) return std::nullopt;
      const std::span<const BoxedEdge> edges(edges_.data() + edge_begin_[other], count);
      const std::optional<int> seen =
          WindingOf(edges, x, y, static_cast<int32_t>(other) == ring ? but : -1);
      if (!seen) return std::nullopt;
      winding += *seen;
    }
    return winding;
  }

  static std::optional<int> WindingOf(std::span<const BoxedEdge> edges, double x, double y,
                                      int32_t but) {
    int winding = 0;
    for (const BoxedEdge& edge : edges) {
      if (!MaySee(x, y, edge.min, edge.max) || edge.index == but) continue;
      const Point d = edge.to - edge.from;
      const double at = static_cast<double>(edge.from.x) + (y - static_cast<double>(edge.from.y)) /
                                                               static_cast<double>(d.y) *
                                                               static_cast<double>(d.x);
      if (std::abs(at - x) < kDoubtNm) return std::nullopt;
      if (at > x) winding += d.y > 0 ? 1 : -1;
    }
    return winding;
  }

  /// Joins the parts with the winding number `least_` to their left into rings. Returns false if
  /// they do not join.
  bool Trace() {
    for (size_t ring = 0; ring < rings_.size(); ++ring)
      if (ring_begin_[ring] == ring_begin_[ring + 1] && whole_winding_[ring] == least_)
        AppendWhole(static_cast<int32_t>(ring));
    for (size_t first = 0; first < edge_crossings_.size(); ++first) {
      if (edge_crossings_[first].used || edge_crossings_[first].winding != least_) continue;
      TracedRing& outline = result_.emplace_back();
      auto at = static_cast<int32_t>(first);
      do {
        if (edge_crossings_[at].used || edge_crossings_[at].winding != least_) return false;
        edge_crossings_[at].used = true;
        const int32_t end = AppendPart(at, outline);
        const Crossing& crossing = crossings_[edge_crossings_[end].crossing];
        // At a crossing, the outline continues with the part that begins there on the other edge.
        at = crossing.edge_crossings[0] == end ? crossing.edge_crossings[1]
                                               : crossing.edge_crossings[0];
      } while (at != static_cast<int32_t>(first));
    }
    return true;
  }

  void AppendWhole(int32_t ring) {
    TracedRing& whole = result_.emplace_back();
    whole.points = Points(ring);
    if (!keeps_edges_) return;
    for (int32_t edge = 0; edge < static_cast<int32_t>(whole.points.size()); ++edge)
      whole.edges.push_back({ring, edge});
  }

  void AppendPoint(Point point, TracedEdge edge, TracedRing& outline) const {
    outline.points.push_back(point);
    if (keeps_edges_) outline.edges.push_back(edge);
  }

  /// Appends the part of a ring that follows an edge crossing; returns the edge crossing at its
  /// end.
  int32_t AppendPart(int32_t at, TracedRing& outline) const {
    const EdgeCrossing& from = edge_crossings_[at];
    const int32_t begin = ring_begin_[from.ring], end = ring_begin_[from.ring + 1];
    const int32_t next = at + 1 == end ? begin : at + 1;
    const EdgeCrossing& to = edge_crossings_[next];
    const Polygon& points = Points(from.ring);
    const auto size = static_cast<int32_t>(points.size());
    AppendPoint(crossings_[from.crossing].place, {from.ring, from.edge}, outline);
    int32_t corners = to.edge - from.edge;
    if (corners < 0 || (corners == 0 && to.along_nm <= from.along_nm)) corners += size;
    for (int32_t corner = from.edge + 1; corners > 0; --corners, ++corner) {
      const int32_t edge = corner < size ? corner : corner - size;
      AppendPoint(points[edge], {from.ring, edge}, outline);
    }
    return next;
  }

  /// Adds each hole to the island around it. Returns nullopt if the island is uncertain.
  std::optional<MultiPolygon> Assemble() {
    MultiPolygon islands;
    std::vector<Polygon> holes;
    for (TracedRing& traced : result_) {
      Polygon& ring = traced.points;
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
      const double area = ring.size() < 3 ? 0 : SignedArea(ring);
      if (area > 0) islands.push_back({std::move(ring), {}});
      if (area < 0) holes.push_back(std::move(ring));
    }
    std::vector<Box> boxes;
    for (const PolygonWithHoles& island : islands) boxes.push_back(Bounds(island.outer));
    for (Polygon& hole : holes) {
      const int island = IslandAround(hole, islands, boxes);
      if (island < 0) return std::nullopt;
      islands[island].holes.push_back(std::move(hole));
    }
    Canonicalize(islands);
    return islands;
  }

  static int IslandAround(const Polygon& hole, const MultiPolygon& islands,
                          const std::vector<Box>& boxes) {
    int around = -1;
    const Box box = Bounds(hole);
    for (size_t i = 0; i < islands.size(); ++i) {
      if (!boxes[i].Intersects(box)) continue;
      const Side side = Locate(hole[0], islands[i].outer);
      if (side == Side::kBoundary) return -1;
      // If islands are nested, the innermost one contains the hole.
      if (side == Side::kInside &&
          (around < 0 || Locate(islands[i].outer[0], islands[around].outer) == Side::kInside)) {
        around = static_cast<int>(i);
      }
    }
    return around;
  }

  std::span<const GroupedRing> rings_;
  int least_;
  std::vector<BoxedEdge> edges_;    ///< in the order of the rings
  std::vector<size_t> edge_begin_;  ///< index of the first edge of each ring
  std::vector<Box> boxes_;          ///< bounding box of each ring
  int64_t looks_left_ = kMostLooks;
  std::vector<Crossing> crossings_;
  std::vector<EdgeCrossing> edge_crossings_;
  /// Index of the first edge crossing of each ring; one entry more than rings.
  std::vector<int32_t> ring_begin_;
  std::vector<int> whole_winding_;  ///< winding number of each ring at its start
  bool keeps_edges_ = false;        ///< true: the result tells the edges that it comes from
  std::vector<TracedRing> result_;
};

}  // namespace

std::optional<MultiPolygon> TryWindingRegion(std::span<const GroupedRing> rings, int least) {
  if (rings.empty()) return MultiPolygon{};
  return Arrangement(rings, least).Region();
}

std::optional<std::vector<TracedRing>> TryWindingRings(std::span<const GroupedRing> rings,
                                                       int least) {
  if (rings.empty()) return std::vector<TracedRing>{};
  return Arrangement(rings, least).TracedRings();
}

}  // namespace slicefarm::internal
