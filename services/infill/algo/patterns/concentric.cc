#include "services/infill/algo/patterns/concentric.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Half of the smallest distance between the sides of a loop, in spacings.
constexpr double kNarrow = 0.35;

}  // namespace

absl::StatusOr<std::vector<Piece>> Concentric(const MultiPolygon& region,
                                              const PatternContext& context) {
  std::vector<Piece> pieces;
  if (region.empty()) return pieces;
  const Box box = Bounds(region);
  const auto size = static_cast<double>(std::min(box.max.x - box.min.x, box.max.y - box.min.y));
  if (absl::Status ok = CheckLineCount(size / 2 / context.pitch_nm); !ok.ok()) return ok;
  // A loop with two sides that would overlap is omitted. Where lines are far apart in any case, an
  // empty area of the same width may remain.
  const double spare = (context.pitch_nm - static_cast<double>(context.spacing_nm)) / 2;
  const Coord narrow =
      std::llround(std::clamp(spare, 0.0, kNarrow * static_cast<double>(context.spacing_nm)));
  // The step from the last loop of a group to the next group makes the mean distance of loops the
  // pitch.
  const int32_t lines = context.shape.lines;
  const auto spacing = static_cast<double>(context.spacing_nm);
  const double to_group = lines * context.pitch_nm - (lines - 1) * spacing;
  int32_t count = 0;
  MultiPolygon left = FastOffset(region, -std::llround(context.first_line * to_group));
  while (!left.empty()) {
    ForEachRing(left, [&pieces](const Polygon& ring) {
      Piece& loop = pieces.emplace_back();
      loop.points = ring;
      loop.closed = true;
    });
    const double step = ++count % lines == 0 ? to_group : spacing;
    left = FastOffset(FastOffset(left, -(std::max<Coord>(1, std::llround(step)) + narrow)), narrow);
  }
  return pieces;
}

}  // namespace slicefarm::infill
