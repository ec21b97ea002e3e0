#include "services/infill/algo/linking/edge_ends.h"

#include <algorithm>
#include <tuple>

namespace slicefarm::infill {

EdgeEnds::EdgeEnds(const MultiPolygon& region, std::span<const Piece> pieces) : pieces_(pieces) {
  ForEachRing(region, [this](const Polygon& ring) {
    rings_.push_back(&ring);
    corner_at_.push_back(CornerLengths(ring));
  });
  ends_.reserve(2 * pieces.size());
  for (const Piece& piece : pieces) {
    ends_.push_back({piece.closed ? EdgePosition{} : piece.from});
    ends_.push_back({piece.closed ? EdgePosition{} : piece.to});
  }
  SortAlongRings();
}

Point EdgeEnds::PositionOf(int32_t end) const {
  const Polyline& points = PieceAt(end / 2).points;
  return end % 2 == 0 ? points.front() : points.back();
}

Polyline EdgeEnds::SpanPoints(int32_t end) const {
  const End& from = At(end);
  const End& to = At(from.next);
  const bool around = from.next == end || to.along_nm < from.along_nm ||
                      (to.along_nm == from.along_nm && from.span_nm > 0);
  Polyline points{PositionOf(end)};
  ForEachCorner(*rings_[static_cast<size_t>(from.place.ring)],
                {from.place.edge, to.place.edge, true, around},
                [&points](Point p) { points.push_back(p); });
  points.push_back(PositionOf(from.next));
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) points.push_back(points.front());
  return points;
}

void EdgeEnds::SortAlongRings() {
  for (int32_t i = 0; i < size(); ++i) {
    if (!IsOnEdge(i)) continue;
    End& end = ends_[static_cast<size_t>(i)];
    const auto ring = static_cast<size_t>(end.place.ring);
    const auto edge = static_cast<size_t>(end.place.edge);
    end.along_nm = corner_at_[ring][edge] + Distance((*rings_[ring])[edge], PositionOf(i));
    order_.push_back(i);
  }
  // The edge is compared first: an end's position is rounded, and may seem to be beyond its edge's
  // last point.
  std::sort(order_.begin(), order_.end(), [this](int32_t a, int32_t b) {
    const End &e = At(a), &f = At(b);
    return std::tuple(e.place.ring, e.place.edge, e.along_nm, a) <
           std::tuple(f.place.ring, f.place.edge, f.along_nm, b);
  });
  for (size_t first = 0; first < order_.size();) {
    const int32_t ring = At(order_[first]).place.ring;
    size_t last = first;
    while (last < order_.size() && At(order_[last]).place.ring == ring) ++last;
    for (size_t i = first; i < last; ++i) {
      const bool wraps = i + 1 == last;
      End& from = ends_[static_cast<size_t>(order_[i])];
      End& to = ends_[static_cast<size_t>(order_[wraps ? first : i + 1])];
      from.next = order_[wraps ? first : i + 1];
      to.previous = order_[i];
      from.span_nm = std::max(0.0, to.along_nm - from.along_nm +
                                       (wraps ? corner_at_[static_cast<size_t>(ring)].back() : 0));
    }
    first = last;
  }
}

void EdgeEnds::SetTaken(const std::vector<std::vector<TakenSpan>>& taken, Coord width_nm) {
  std::vector<TakenRing> rings;
  for (size_t ring = 0; ring < taken.size(); ++ring)
    rings.emplace_back(taken[ring], corner_at_[ring].back());
  for (const int32_t number : order_) {
    End& end = ends_[static_cast<size_t>(number)];
    end.clearance = rings[static_cast<size_t>(end.place.ring)].Along(end.along_nm, end.span_nm,
                                                                     static_cast<double>(width_nm));
  }
}

}  // namespace slicefarm::infill
