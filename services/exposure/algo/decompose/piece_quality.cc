#include "services/exposure/algo/decompose/piece_quality.h"

#include <algorithm>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "services/exposure/algo/decompose/cut_region.h"

namespace slicefarm::exposure {

double LeastAngleDeg(const Polygon& piece) {
  double least = std::numbers::pi;
  for (size_t i = 0; i < piece.size(); ++i) {
    const Point to_before = Before(piece, i) - piece[i], to_after = After(piece, i) - piece[i];
    least = std::min(least, Atan2(Cross(to_after, to_before), Dot(to_after, to_before)));
  }
  return least * 180 / std::numbers::pi;
}

double ShapeFactor(const Polygon& piece) {
  const double perimeter = Perimeter(piece);
  return perimeter * perimeter / (4 * std::numbers::pi * SignedArea(piece));
}

}  // namespace slicefarm::exposure
