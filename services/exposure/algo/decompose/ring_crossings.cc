#include "services/exposure/algo/decompose/ring_crossings.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/simple_rings.h"

namespace slicefarm::exposure {
namespace {

struct Edge {
  Point a, b;
  Coord Left() const { return std::min(a.x, b.x); }
  Coord Right() const { return std::max(a.x, b.x); }
};

/// Whether edges cross in the inside of both, or share more than a point.
bool Collide(const Edge& e, const Edge& f) {
  if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) ||
      std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y))
    return false;
  const int fa = Orientation(e.a, e.b, f.a), fb = Orientation(e.a, e.b, f.b);
  if (fa == 0 && fb == 0) {
    const auto [e_low, e_high] = std::minmax(e.a, e.b);
    const auto [f_low, f_high] = std::minmax(f.a, f.b);
    return std::max(e_low, f_low) < std::min(e_high, f_high);
  }
  return fa * fb < 0 && Orientation(f.a, f.b, e.a) * Orientation(f.a, f.b, e.b) < 0;
}

absl::Status Malformed(const char* what, Point at) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("the outline's rings {} near ({:.6f}, {:.6f}) mm", what,
                               ToMm(static_cast<double>(at.x)), ToMm(static_cast<double>(at.y))));
}

absl::Status CheckPairs(const MultiPolygon& islands) {
  std::vector<Edge> edges;
  ForEachRing(islands, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      if (const Edge edge{ring[i], ring[(i + 1) % ring.size()]}; edge.a != edge.b)
        edges.push_back(edge);
  });
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.Left() < f.Left(); });
  for (size_t i = 0; i < edges.size(); ++i)
    for (size_t j = i + 1; j < edges.size() && edges[j].Left() <= edges[i].Right(); ++j)
      if (Collide(edges[i], edges[j])) return Malformed("cross or overlap", edges[j].a);
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckCrossings(const MultiPolygon& islands) {
  std::vector<const Polygon*> rings;
  for (const PolygonWithHoles& island : islands) {
    if (SignedArea(island.outer) < 0) return Malformed("are turned the wrong way", island.outer[0]);
    rings.push_back(&island.outer);
    for (const Polygon& hole : island.holes) {
      if (SignedArea(hole) > 0) return Malformed("are turned the wrong way", hole[0]);
      rings.push_back(&hole);
    }
  }
  return AreSimple(rings) ? absl::OkStatus() : CheckPairs(islands);
}

}  // namespace slicefarm::exposure
