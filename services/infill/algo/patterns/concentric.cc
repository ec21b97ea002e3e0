#include "services/infill/algo/patterns/concentric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> Concentric(const MultiPolygon& region,
                                              const PatternPlace& place) {
  std::vector<Piece> pieces;
  if (region.empty()) return pieces;
  const Box box = Bounds(region);
  const auto size = static_cast<double>(std::min(box.max.x - box.min.x, box.max.y - box.min.y));
  if (absl::Status ok = CheckLineCount(size / 2 / place.pitch_nm); !ok.ok()) return ok;
  MultiPolygon left = FastOffset(region, -std::llround(place.pitch_nm / 2));
  while (!left.empty()) {
    ForEachRing(left, [&pieces](const Polygon& ring) {
      Piece& loop = pieces.emplace_back();
      loop.points = ring;
      loop.closed = true;
    });
    left = FastOffset(left, -std::max<Coord>(1, std::llround(place.pitch_nm)));
  }
  return pieces;
}

}  // namespace slicefarm::infill
