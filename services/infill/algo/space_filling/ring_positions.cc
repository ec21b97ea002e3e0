#include "services/infill/algo/space_filling/ring_positions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::infill {
namespace {

Box BoundsOf(const std::vector<const Polygon*>& rings) {
  Box box{{0, 0}, {0, 0}};
  if (!rings.empty()) box = Bounds(*rings[0]);
  for (const Polygon* ring : rings) box.Add(Bounds(*ring));
  return box;
}

}  // namespace

RingPositions::RingPositions(std::vector<const Polygon*> rings, double cell_nm)
    : rings_(std::move(rings)), extent_(BoundsOf(rings_)), grid_(extent_, cell_nm) {
  int32_t segment = 0;
  for (int32_t r = 0; r < Count(); ++r) {
    const Polygon& ring = *rings_[r];
    first_.push_back(segment);
    double length = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
      along_.push_back(length);
      length += Distance(from, to);
      const double squared = SquaredNorm(to - from);
      segments_.push_back({from, to - from, squared > 0 ? 1 / squared : 0, r});
      grid_.Add(from, to, segment++);
    }
    along_.push_back(length);
  }
  first_.push_back(segment);
}

double RingPositions::Wrapped(int32_t ring, double position) const {
  const double length = Length(ring);
  position -= length * std::floor(position / length);
  return position < length ? position : 0;
}

int32_t RingPositions::EdgeAt(int32_t ring, double position) const {
  const double* const along = Along(ring);
  const auto size = static_cast<int32_t>(rings_[ring]->size());
  return static_cast<int32_t>(std::upper_bound(along, along + size, position) - along) - 1;
}

Point RingPositions::At(int32_t ring, double position) const {
  position = Wrapped(ring, position);
  const int32_t i = EdgeAt(ring, position);
  const Polygon& points = *rings_[ring];
  const Point a = points[i],
              d = points[i + 1 == static_cast<int32_t>(points.size()) ? 0 : i + 1] - a;
  const double from = Along(ring)[i], to = Along(ring)[i + 1];
  const double part = to > from ? (position - from) / (to - from) : 0;
  return {a.x + std::llround(part * static_cast<double>(d.x)),
          a.y + std::llround(part * static_cast<double>(d.y))};
}

RingPositions::Edge RingPositions::EdgeOf(int32_t segment) const {
  const Segment& s = segments_[segment];
  return {s.from, s.from + s.direction, s.ring, segment - first_[s.ring]};
}

double RingPositions::PositionOn(const Edge& edge, Point p) const {
  const double* const along = Along(edge.ring) + edge.index;
  return along[0] + segments_[first_[edge.ring] + edge.index].Part(p) * (along[1] - along[0]);
}

std::optional<RingPositions::Near> RingPositions::Nearest(Point p, int32_t ring,
                                                          double reach) const {
  double best = reach * reach;
  int32_t nearest = -1;
  grid_.ForEachNear(p, p, reach, [&](int32_t s) {
    if (segments_[s].ring != ring) return;
    const double squared = segments_[s].SquaredDistance(p);
    if (squared > best || (squared == best && nearest >= 0 && s >= nearest)) return;
    best = squared;
    nearest = s;
  });
  if (nearest < 0) return std::nullopt;
  return Near{Wrapped(ring, PositionOn(EdgeOf(nearest), p)), std::sqrt(best)};
}

}  // namespace slicefarm::infill
