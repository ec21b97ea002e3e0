#include "services/infill/algo/space_filling/ring_links.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "common/base/disjoint_sets.h"
#include "common/geometry/predicates.h"
#include "services/infill/algo/space_filling/ring_positions.h"

namespace slicefarm::infill {
namespace {

/// Piece cut out of a ring: forward from a position.
struct Cut {
  int32_t ring = 0;
  double from = 0;
  double length = 0;
};

/// Connection of two rings: both are cut, and the ends of the cuts are linked. The links run from
/// start to start if the rings have the same direction there, else from start to end.
struct Bridge {
  std::array<Cut, 2> cuts;
  bool same_way = true;
};

/// End of a cut, where the rest of the ring begins or ends: 4 * bridge + 2 * side + (1 at the cut's
/// end).
using End = int32_t;

/// Distance up to which two ends count as equal, in spacings.
constexpr double kSnap = 0.02;
/// Largest misfit of a good bridge, in spacings: the difference between its links' lengths and the
/// spacing, plus a weighted difference of its cuts.
constexpr double kGoodFit = 0.1;
constexpr double kCutsMatter = 0.5;
/// Smallest length of the shorter cut as a share of the longer one, for rings with sharp bends.
constexpr double kLeastCut = 0.1;

/// Smallest length, in spacings, of cuts that are as long as their links.
constexpr double kShortestApart = 0.25;

struct Pass {
  bool other_steps_only = true;
  double reach = 0;         ///< longest link
  double gap = 0;           ///< longest cut
  bool as_apart = false;    ///< cuts are as long as their links, so that no length changes
  double worst = INFINITY;  ///< largest misfit of a bridge
};

/// Position on a ring that is near the ring `near`. The index `near` is lower than the ring's own
/// index.
struct Spot {
  int32_t near = 0;
  double position = 0;
  double distance = 0;
};

/// Two rings near each other.
struct Pair {
  int32_t a = 0;
  int32_t b = 0;
  double misfit = 0;        ///< smallest difference between their distance and a spacing
  std::vector<Spot> spots;  ///< positions on b, in order
};

bool DoSegmentsCross(Point a, Point b, Point c, Point d) {
  const auto apart = [](Coord p, Coord q, Coord r, Coord s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  // The test also separates segments beside each other on one line.
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  return Orientation(a, b, c) * Orientation(a, b, d) <= 0 &&
         Orientation(c, d, a) * Orientation(c, d, b) <= 0;
}

class Linker {
 public:
  Linker(std::span<const StepRing> rings, double spacing,
         const std::function<bool(Point, Point)>& may_link)
      : rings_(rings),
        spacing_(spacing),
        may_link_(may_link),
        places_(Points(rings), 1.5 * spacing),
        links_(places_.Extent(), 1.5 * spacing),
        bridges_at_(rings.size()),
        families_(static_cast<int32_t>(rings.size())) {}

  std::vector<Polyline> Link() {
    Run({.reach = 1.3 * spacing_, .gap = spacing_, .worst = kGoodFit});
    Run({.reach = 1.3 * spacing_, .gap = spacing_});
    if (AreOfOneStep()) {
      Run({.other_steps_only = false,
           .reach = 2.5 * spacing_,
           .gap = 2.5 * spacing_,
           .as_apart = true});
    }
    for (const double gap : {1.0, 0.5, 0.25})
      Run({.other_steps_only = false, .reach = 2.5 * spacing_, .gap = gap * spacing_});
    return Paths();
  }

 private:
  static std::vector<const Polygon*> Points(std::span<const StepRing> rings) {
    std::vector<const Polygon*> points;
    for (const StepRing& ring : rings) points.push_back(&ring.points);
    return points;
  }

  bool AreOfOneStep() const {
    return std::ranges::all_of(
        rings_, [this](const StepRing& ring) { return ring.step == rings_.front().step; });
  }

  void Run(const Pass& pass) {
    if (families_.sets() < 2) return;
    std::vector<Pair> pairs = Pairs(pass);
    for (const Pair& pair : pairs) {
      if (families_.AreJoined(pair.a, pair.b)) continue;
      if (const std::optional<Bridge> bridge = Find(pair, pass)) Build(*bridge);
    }
  }

  /// Returns the pairs of rings within reach of each other. They are sorted by the higher index,
  /// then by the lower index in descending order. In passes over all steps, pairs with distances
  /// nearest to a spacing are first.
  std::vector<Pair> Pairs(const Pass& pass) {
    std::vector<Pair> pairs;
    std::vector<Spot> spots;
    for (int32_t b = 0; b < places_.Count(); ++b) {
      FindSpots(b, pass, spots);
      for (auto begin = spots.begin(); begin != spots.end();) {
        const auto end = std::find_if(begin, spots.end(),
                                      [&](const Spot& spot) { return spot.near != begin->near; });
        Pair& pair = pairs.emplace_back(Pair{begin->near, b, INFINITY, {begin, end}});
        for (const Spot& spot : pair.spots)
          pair.misfit = std::min(pair.misfit, std::abs(spot.distance - spacing_));
        begin = end;
      }
    }
    if (!pass.other_steps_only) {
      std::stable_sort(pairs.begin(), pairs.end(),
                       [](const Pair& x, const Pair& y) { return x.misfit < y.misfit; });
    }
    return pairs;
  }

  /// Finds positions on ring `b` within reach of rings with a lower index that are not in its
  /// family. The positions are sorted by the index of the other ring in descending order, then
  /// along ring `b`.
  void FindSpots(int32_t b, const Pass& pass, std::vector<Spot>& spots) {
    spots.clear();
    std::vector<RingPositions::NearRing> near;
    const auto wanted = [&](int32_t a) {
      return a < b && !families_.AreJoined(a, b) &&
             !(pass.other_steps_only && rings_[a].step == rings_[b].step);
    };
    ForEachSample(b, [&](double position) {
      places_.NearRings(places_.At(b, position), pass.reach, wanted, near);
      for (const auto& [a, distance] : near) spots.push_back({a, position, distance});
    });
    std::stable_sort(spots.begin(), spots.end(),
                     [](const Spot& x, const Spot& y) { return x.near > y.near; });
  }

  template <typename Visit>
  void ForEachSample(int32_t ring, Visit visit) const {
    const double length = places_.Length(ring);
    const auto count = std::max<int64_t>(4, std::llround(length / spacing_));
    for (int64_t i = 0; i < count; ++i)
      visit((static_cast<double>(i) + 0.5) * length / static_cast<double>(count));
  }

  /// Returns the first good bridge between two rings (kGoodFit), or the bridge with the smallest
  /// misfit if none is good.
  std::optional<Bridge> Find(const Pair& pair, const Pass& pass) const {
    // Cuts are measured on the longer ring, and transferred to the shorter one.
    const bool a_longer = places_.Length(pair.a) >= places_.Length(pair.b);
    const int32_t from = a_longer ? pair.a : pair.b, to = a_longer ? pair.b : pair.a;
    std::optional<Bridge> best;
    double best_misfit = pass.worst + 1e-9;
    const auto gap_at = [&](double apart) {
      return pass.as_apart ? std::clamp(apart, kShortestApart * spacing_, pass.gap) : pass.gap;
    };
    const auto attempt = [&](double start, double gap) {
      double misfit = 0;
      const auto bridge = Fit(from, start, to, gap, pass, misfit);
      if (!bridge || misfit >= best_misfit) return;
      best = bridge;
      best_misfit = misfit;
    };
    size_t first = 0;
    if (!bridges_at_[pair.a].empty()) {
      // The first attempt is at the end of the cut that the ring has for its parent, or near it.
      const Cut& cut = CutAt(pair.a, bridges_at_[pair.a].front());
      const Point seam = places_.At(pair.a, cut.from + cut.length);
      if (const auto start = places_.Nearest(seam, from, pass.reach))
        attempt(start->position, gap_at(DistanceTo(to, start->position, from, pass)));
      if (!best || best_misfit > kGoodFit) first = NearestSpot(pair, seam);
    }
    for (size_t i = 0; i < pair.spots.size() && (!best || best_misfit > kGoodFit); ++i) {
      const Spot& spot = pair.spots[(first + i) % pair.spots.size()];
      const auto middle = places_.Nearest(places_.At(pair.b, spot.position), from, pass.reach);
      const double gap = gap_at(spot.distance);
      if (middle) attempt(middle->position - gap / 2, gap);
    }
    if (best && !a_longer) std::swap(best->cuts[0], best->cuts[1]);
    return best;
  }

  /// Returns the distance from a position on ring `from` to ring `to`, at most the pass's reach.
  double DistanceTo(int32_t to, double position, int32_t from, const Pass& pass) const {
    const auto near = places_.Nearest(places_.At(from, position), to, pass.reach);
    return near ? near->distance : pass.reach;
  }

  size_t NearestSpot(const Pair& pair, Point p) const {
    const auto apart = [&](const Spot& spot) {
      return SquaredNorm(places_.At(pair.b, spot.position) - p);
    };
    const auto nearest =
        std::min_element(pair.spots.begin(), pair.spots.end(),
                         [&](const Spot& x, const Spot& y) { return apart(x) < apart(y); });
    return static_cast<size_t>(nearest - pair.spots.begin());
  }

  /// Returns a bridge from a cut of ring `from` that begins at `start` to the part of ring `to`
  /// that faces it.
  std::optional<Bridge> Fit(int32_t from, double start, int32_t to, double longest,
                            const Pass& pass, double& misfit) const {
    const double gap = std::min(longest, 0.4 * places_.Length(from));
    const double begin = Snapped(from, start), end = Snapped(from, start + gap);
    Cut cut{from, begin, places_.Wrapped(from, end - begin)};
    if (cut.length > 1.1 * gap || cut.length < 0.5 * gap || !IsFree(cut)) return std::nullopt;
    const Point p0 = places_.At(from, begin), p1 = places_.At(from, end);
    const auto q0 = places_.Nearest(p0, to, pass.reach), q1 = places_.Nearest(p1, to, pass.reach);
    if (!q0 || !q1) return std::nullopt;
    const double t0 = Snapped(to, q0->position), t1 = Snapped(to, q1->position);
    const double forward = places_.Wrapped(to, t1 - t0), whole = places_.Length(to);
    const bool same_way = forward <= whole / 2;
    const Cut other = same_way ? Cut{to, t0, forward} : Cut{to, t1, whole - forward};
    if (other.length < kLeastCut * cut.length || other.length > 2 * cut.length || !IsFree(other))
      return std::nullopt;
    misfit = (std::abs(q0->distance - spacing_) + std::abs(q1->distance - spacing_) +
              kCutsMatter * std::abs(other.length - cut.length)) /
             spacing_;
    const Bridge bridge{{cut, other}, same_way};
    const Point r0 = places_.At(to, t0), r1 = places_.At(to, t1);
    if (p0 == r0 || p1 == r1 || DoSegmentsCross(p0, r0, p1, r1)) return std::nullopt;
    if (!IsClear(p0, r0, bridge) || !IsClear(p1, r1, bridge)) return std::nullopt;
    return bridge;
  }

  /// Returns a position, or the end of a cut if it is very near.
  double Snapped(int32_t ring, double position) const {
    for (const int32_t b : bridges_at_[ring]) {
      const Cut& cut = CutAt(ring, b);
      for (const double end : {cut.from, cut.from + cut.length}) {
        const double apart = places_.Wrapped(ring, position - end + kSnap * spacing_);
        if (apart <= 2 * kSnap * spacing_) return places_.Wrapped(ring, end);
      }
    }
    return places_.Wrapped(ring, position);
  }

  const Cut& CutAt(int32_t ring, int32_t bridge) const {
    const auto& cuts = bridges_[bridge].cuts;
    return cuts[0].ring == ring ? cuts[0] : cuts[1];
  }

  /// Returns true if no part of this piece has been cut yet.
  bool IsFree(const Cut& cut) const {
    const double length = places_.Length(cut.ring);
    return std::all_of(
        bridges_at_[cut.ring].begin(), bridges_at_[cut.ring].end(), [&](int32_t bridge) {
          const Cut& other = CutAt(cut.ring, bridge);
          // Cuts may overlap by a nanometre because of rounding.
          const double after = places_.Wrapped(cut.ring, other.from - cut.from + 1) - 1;
          return after >= cut.length - 1 && after + other.length <= length + 1;
        });
  }

  /// Returns true if a link crosses neither other links nor the remaining parts of the rings.
  bool IsClear(Point a, Point b, const Bridge& bridge) const {
    // The link's ends are on the rings except for rounding, so that they are not tested.
    constexpr double kShorter = 20;
    const double length = Distance(a, b);
    if (length < 4 * kShorter) return true;
    const auto part = [&](double at) {
      return Point{a.x + std::llround(at / length * static_cast<double>(b.x - a.x)),
                   a.y + std::llround(at / length * static_cast<double>(b.y - a.y))};
    };
    const Point from = part(kShorter), to = part(length - kShorter);
    bool clear = !may_link_ || may_link_(from, to);
    places_.ForEachEdgeNear(from, to, [&](const RingPositions::Edge& edge) {
      if (!clear || !DoSegmentsCross(from, to, edge.from, edge.to)) return;
      clear = IsCutAway(edge, from, to, bridge);
    });
    if (!clear) return false;
    links_.ForEachNear(from, to, 1, [&](End end) {
      clear = clear && !DoSegmentsCross(from, to, At(end), At(Across(end)));
    });
    return clear;
  }

  /// Returns true if the point of an edge that a segment crosses has been cut away.
  bool IsCutAway(const RingPositions::Edge& edge, Point from, Point to,
                 const Bridge& bridge) const {
    const Point route = to - from, d = edge.to - edge.from;
    const double turn = Cross(d, route);
    if (turn == 0) return false;
    const double part = Cross(from - edge.from, route) / turn;
    const double position =
        places_.PositionOn(edge, {edge.from.x + std::llround(part * static_cast<double>(d.x)),
                                  edge.from.y + std::llround(part * static_cast<double>(d.y))});
    const auto in = [&](const Cut& cut) {
      return cut.ring == edge.ring && places_.Wrapped(cut.ring, position - cut.from) < cut.length;
    };
    return in(bridge.cuts[0]) || in(bridge.cuts[1]) ||
           std::any_of(bridges_at_[edge.ring].begin(), bridges_at_[edge.ring].end(),
                       [&](int32_t other) { return in(CutAt(edge.ring, other)); });
  }

  void Build(const Bridge& bridge) {
    const auto index = static_cast<int32_t>(bridges_.size());
    bridges_.push_back(bridge);
    for (const Cut& cut : bridge.cuts) bridges_at_[cut.ring].push_back(index);
    for (const End end : {4 * index, 4 * index + 1}) links_.Add(At(end), At(Across(end)), end);
    families_.Join(bridge.cuts[0].ring, bridge.cuts[1].ring);
  }

  // --- walking the result
  // -------------------------------------------------------------------------

  const Cut& CutOf(End end) const { return bridges_[end / 4].cuts[end / 2 % 2]; }
  Point At(End end) const {
    const Cut& cut = CutOf(end);
    return places_.At(cut.ring, end % 2 == 0 ? cut.from : cut.from + cut.length);
  }
  /// Returns the other end of the link that begins at this end.
  End Across(End end) const { return bridges_[end / 4].same_way ? end ^ 2 : end ^ 3; }

  /// Returns for each end the other end of the remaining piece of ring.
  std::vector<End> Pieces() const {
    std::vector<End> other(4 * bridges_.size());
    for (int32_t ring = 0; ring < places_.Count(); ++ring) {
      std::vector<End> starts;
      for (const int32_t b : bridges_at_[ring])
        starts.push_back(4 * b + (bridges_[b].cuts[0].ring == ring ? 0 : 2));
      std::sort(starts.begin(), starts.end(),
                [&](End x, End y) { return CutOf(x).from < CutOf(y).from; });
      for (size_t i = 0; i < starts.size(); ++i) {
        const End next = starts[i + 1 == starts.size() ? 0 : i + 1];
        other[starts[i] + 1] = next;
        other[next] = starts[i] + 1;
      }
    }
    return other;
  }

  void AppendPiece(End from, End to, Polyline& path) const {
    const auto append = [&path](Point p) {
      if (path.empty() || path.back() != p) path.push_back(p);
    };
    const bool forward = from % 2 == 1;
    const Cut& start = CutOf(forward ? from : to);
    const Cut& stop = CutOf(forward ? to : from);
    const double begin = start.from + start.length;
    double length = places_.Wrapped(start.ring, stop.from - begin);
    // A piece without length may have a slightly negative length.
    if (length > places_.Length(start.ring) - 2 && &start != &stop) length = 0;
    Polyline corners;
    places_.ForEachCornerBetween(start.ring, begin, length, [&](Point p) { corners.push_back(p); });
    if (!forward) std::reverse(corners.begin(), corners.end());
    append(At(from));
    for (const Point p : corners) append(p);
    append(At(to));
  }

  std::vector<Polyline> Paths() const {
    std::vector<int32_t> by_step(rings_.size());
    std::iota(by_step.begin(), by_step.end(), 0);
    std::stable_sort(by_step.begin(), by_step.end(),
                     [&](int32_t x, int32_t y) { return rings_[x].step < rings_[y].step; });
    std::vector<Polyline> paths;
    const std::vector<End> other = Pieces();
    std::vector<char> done(other.size(), false);
    for (const int32_t ring : by_step) {
      if (bridges_at_[ring].empty()) {
        Polyline& closed = paths.emplace_back(rings_[ring].points);
        closed.push_back(closed.front());
        continue;
      }
      const int32_t bridge = bridges_at_[ring].front();
      const End start = 4 * bridge + (bridges_[bridge].cuts[0].ring == ring ? 0 : 2);
      if (done[start]) continue;
      Polyline path;
      for (End end = start; !done[end];) {
        const End to = other[end];
        AppendPiece(end, to, path);
        done[end] = done[to] = true;
        end = Across(to);
      }
      paths.push_back(std::move(path));
    }
    return paths;
  }

  std::span<const StepRing> rings_;
  double spacing_;
  const std::function<bool(Point, Point)>& may_link_;
  RingPositions places_;
  SegmentGrid links_;  ///< links, numbered by the end on the first ring
  std::vector<Bridge> bridges_;
  std::vector<std::vector<int32_t>> bridges_at_;  ///< bridges of each ring, the oldest first
  DisjointSets families_;                         ///< sets of joined rings
};

}  // namespace

std::vector<Polyline> LinkRings(std::span<const StepRing> rings, double spacing_nm,
                                const std::function<bool(Point, Point)>& may_link) {
  if (rings.empty()) return {};
  return Linker(rings, spacing_nm, may_link).Link();
}

}  // namespace slicefarm::infill
