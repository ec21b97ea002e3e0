#include "services/beading/algo/arachne/outline_index.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/vector.h"

namespace slicefarm::beading {
namespace {

/// Side of the index's squares, about the usual distance between a position and the nearest
/// outline.
constexpr Coord kOutlineSquareNm = 700'000;

/// Returns the square of the distance from `place` to an edge.
double SquareToEdge(const Vector2& place, const EdgeIndex::Edge& edge) {
  const Vector2 from = ToVector(edge.a), to = ToVector(edge.b), along = to - from;
  const double dot = Dot(place - from, along), square = Dot(along, along);
  Vector2 nearest = from;
  if (dot >= square)
    nearest = to;
  else if (dot > 0)
    nearest = from + dot / square * along;
  const Vector2 apart = place - nearest;
  return Dot(apart, apart);
}

}  // namespace

OutlineIndex::OutlineIndex(const MultiPolygon& outlines) : edges_(outlines, kOutlineSquareNm) {}

double OutlineIndex::DistanceFrom(double x, double y, double limit_nm) const {
  const auto reach = static_cast<Coord>(std::ceil(limit_nm)) + 1;
  const Point middle{std::llround(x), std::llround(y)};
  double least = limit_nm * limit_nm;
  bool found = false;
  edges_.ForEachNear(Box{middle, middle}.Grown(reach), [&](int32_t edge) {
    const double square = SquareToEdge({x, y}, edges_.At(edge));
    if (square > least) return;
    least = square;
    found = true;
  });
  return found ? std::sqrt(least) : std::numeric_limits<double>::infinity();
}

}  // namespace slicefarm::beading
