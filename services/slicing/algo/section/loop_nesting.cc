#include "services/slicing/algo/section/loop_nesting.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/geometry/predicates.h"

namespace slicefarm::slicing {
namespace {

constexpr uint32_t kNoLoop = UINT32_MAX;
constexpr int64_t kTestsPerEdge = 400;

bool IsInside(int winding, FillRule rule) {
  switch (rule) {
    case FillRule::kNonZero:
      return winding != 0;
    case FillRule::kEvenOdd:
      return winding % 2 != 0;
    case FillRule::kPositive:
      return winding > 0;
  }
  return false;
}

struct Edge {
  Point left;  ///< the lesser end
  Point right;
  uint32_t loop = 0;
  uint32_t index = 0;  ///< index in its loop of the corner at which the edge begins
  bool to_right = false;

  Coord Bottom() const { return std::min(left.y, right.y); }
  Coord Top() const { return std::max(left.y, right.y); }
};

/// Result of the sweep for a loop. It is found at the loop's smallest corner, the first one in the
/// sweep.
struct Nest {
  uint32_t parent = kNoLoop;  ///< loop immediately around this loop; kNoLoop: there is none
  int outside = 0;            ///< winding number outside the loop
  int inside = 0;
  bool counter_clockwise = false;
};

class LoopNester {
 public:
  LoopNester(const std::vector<Polygon>& loops, FillRule rule) : loops_(loops), rule_(rule) {
    size_t count = 0;
    for (const Polygon& loop : loops) count += loop.size();
    edges_.reserve(count);
    for (uint32_t i = 0; i < loops.size(); ++i) AddEdges(i);
    std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
      return a.left != b.left ? a.left < b.left : a.right < b.right;
    });
    budget_ = kTestsPerEdge * static_cast<int64_t>(count);
  }

  /// Sweeps over all edges. Returns false if two edges meet or the budget is spent.
  bool Sweep() {
    nests_.resize(loops_.size());
    std::vector<bool> seen(loops_.size(), false);
    for (const Edge& edge : edges_) {
      DropPassed(edge.left);
      budget_ -= static_cast<int64_t>(active_.size());
      if (budget_ < 0) return false;
      if (!seen[edge.loop]) {
        seen[edge.loop] = true;
        Nestle(edge);
      }
      for (const Edge* other : active_)
        if (Meet(edge, *other)) return false;
      active_.push_back(&edge);
    }
    return true;
  }

  MultiPolygon Islands() const {
    MultiPolygon islands;
    std::vector<uint32_t> island_of(loops_.size(), kNoLoop);
    for (uint32_t i = 0; i < loops_.size(); ++i) {
      if (!IsOuter(i)) continue;
      island_of[i] = static_cast<uint32_t>(islands.size());
      islands.push_back({Turned(i, true), {}});
    }
    for (uint32_t i = 0; i < loops_.size(); ++i) {
      if (!IsHole(i)) continue;
      uint32_t around = nests_[i].parent;
      while (!IsOuter(around)) around = nests_[around].parent;
      islands[island_of[around]].holes.push_back(Turned(i, false));
    }
    Canonicalize(islands);
    return islands;
  }

 private:
  void AddEdges(uint32_t loop) {
    const Polygon& ring = loops_[loop];
    for (uint32_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      edges_.push_back({std::min(a, b), std::max(a, b), loop, i, a < b});
    }
  }

  void DropPassed(Point at) {
    size_t kept = 0;
    for (const Edge* edge : active_)
      if (!(edge->right < at)) active_[kept++] = edge;
    active_.resize(kept);
  }

  bool AreNeighbours(const Edge& a, const Edge& b) const {
    if (a.loop != b.loop) return false;
    const uint32_t size = static_cast<uint32_t>(loops_[a.loop].size());
    const uint32_t distance = a.index > b.index ? a.index - b.index : b.index - a.index;
    return distance == 1 || distance == size - 1;
  }

  bool Meet(const Edge& a, const Edge& b) const {
    if (a.Bottom() > b.Top() || b.Bottom() > a.Top() || AreNeighbours(a, b)) return false;
    return Orientation(a.left, a.right, b.left) * Orientation(a.left, a.right, b.right) <= 0 &&
           Orientation(b.left, b.right, a.left) * Orientation(b.left, b.right, a.right) <= 0;
  }

  /// Returns true if a is above b. The edges do not cross, and some vertical line meets both of
  /// them.
  static bool IsAbove(const Edge& a, const Edge& b) {
    if (b.left <= a.left) {
      const int side = Orientation(b.left, b.right, a.left);
      return (side != 0 ? side : Orientation(b.left, b.right, a.right)) > 0;
    }
    const int side = Orientation(a.left, a.right, b.left);
    return (side != 0 ? side : Orientation(a.left, a.right, b.right)) < 0;
  }

  /// Sets the nest of a loop at its smallest corner, where `edge` begins, by looking at the edges
  /// below this corner. Edges that end at this x are ignored and edges that begin at it count, as
  /// if the line of sight were slightly to the right.
  void Nestle(const Edge& edge) {
    const Point corner = edge.left;
    Nest& nest = nests_[edge.loop];
    const Edge* nearest = nullptr;
    for (const Edge* other : active_) {
      if (other->right.x <= corner.x || Orientation(other->left, other->right, corner) <= 0)
        continue;
      nest.outside += other->to_right ? 1 : -1;
      if (nearest == nullptr || IsAbove(*other, *nearest)) nearest = other;
    }
    nest.counter_clockwise = IsCounterClockwise(edge);
    nest.inside = nest.outside + (nest.counter_clockwise ? 1 : -1);
    if (nearest == nullptr) return;
    // The left of an edge is the inside of a counter-clockwise loop.
    const Nest& below = nests_[nearest->loop];
    nest.parent = nearest->to_right == below.counter_clockwise ? nearest->loop : below.parent;
  }

  /// Returns the loop's direction, from the true corner at the left end of its first edge.
  bool IsCounterClockwise(const Edge& edge) const {
    const Polygon& ring = loops_[edge.loop];
    const size_t size = ring.size();
    const size_t at = edge.to_right ? edge.index : (edge.index + 1) % size;
    return Orientation(ring[(at + size - 1) % size], ring[at], ring[(at + 1) % size]) > 0;
  }

  bool IsOuter(uint32_t loop) const {
    return !IsInside(nests_[loop].outside, rule_) && IsInside(nests_[loop].inside, rule_);
  }
  bool IsHole(uint32_t loop) const {
    return IsInside(nests_[loop].outside, rule_) && !IsInside(nests_[loop].inside, rule_);
  }

  Polygon Turned(uint32_t loop, bool counter_clockwise) const {
    Polygon ring = loops_[loop];
    if (nests_[loop].counter_clockwise != counter_clockwise) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  const std::vector<Polygon>& loops_;
  FillRule rule_;
  int64_t budget_ = 0;
  std::vector<Edge> edges_;
  std::vector<const Edge*> active_;
  std::vector<Nest> nests_;
};

}  // namespace

std::optional<MultiPolygon> NestSimpleLoops(const std::vector<Polygon>& loops, FillRule rule) {
  LoopNester nester(loops, rule);
  if (!nester.Sweep()) return std::nullopt;
  return nester.Islands();
}

}  // namespace slicefarm::slicing
