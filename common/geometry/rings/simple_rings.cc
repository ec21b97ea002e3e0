#include "common/geometry/rings/simple_rings.h"

#include <vector>

#include "common/geometry/boolean/near_edges.h"
#include "common/geometry/predicates.h"

namespace slicefarm {
namespace {

using internal::BoxedEdge;

/// Returns true if two edges meet in any other manner than as consecutive edges at a corner.
bool Collide(const BoxedEdge& e, const BoxedEdge& f) {
  const int to_from = Orientation(e.from, e.to, f.from), to_to = Orientation(e.from, e.to, f.to);
  if (to_from * to_to > 0) return false;
  const int from_from = Orientation(f.from, f.to, e.from);
  const int from_to = Orientation(f.from, f.to, e.to);
  if (from_from * from_to > 0) return false;
  // Consecutive edges share only one point, around a corner or straight on.
  if (e.to == f.from && (to_to != 0 || Dot(e.to - e.from, f.to - f.from) > 0)) return false;
  if (f.to == e.from && (to_from != 0 || Dot(e.to - e.from, f.to - f.from) > 0)) return false;
  if (to_from != 0 || to_to != 0) return true;
  return OnSegment(f.from, e.from, e.to) || OnSegment(f.to, e.from, e.to) ||
         OnSegment(e.from, f.from, f.to);
}

}  // namespace

bool AreSimple(std::span<const Polygon* const> rings) {
  size_t count = 0;
  for (const Polygon* ring : rings) {
    if (ring->size() < 3) return false;
    count += ring->size();
  }
  std::vector<BoxedEdge> edges;
  edges.reserve(count);
  for (const Polygon* ring : rings) internal::AppendBoxedEdges(*ring, 0, edges);
  for (const BoxedEdge& edge : edges)
    if (edge.from == edge.to) return false;
  return internal::ForEachNearPair(
      std::span<const BoxedEdge>(edges),
      [](const BoxedEdge& e, const BoxedEdge& f) { return !Collide(e, f); });
}

}  // namespace slicefarm
