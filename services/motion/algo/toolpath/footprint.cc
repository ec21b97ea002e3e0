#include "services/motion/algo/toolpath/footprint.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/geometry/convex.h"

namespace slicefarm::motion {
namespace {

/// End of a bead on the plate.
struct BeadEnd {
  Point place;
  Coord width_nm = 0;
};

std::vector<BeadEnd> EndsOf(std::span<const MoveSpan> program) {
  std::vector<BeadEnd> ends;
  for (const MoveSpan& span : program) {
    const std::vector<Move>& moves = span.path->moves;
    for (size_t i = std::max<size_t>(span.first, 1); i < span.last; ++i) {
      if (moves[i].kind != MoveKind::kPrint) continue;
      for (const Move* move : {&moves[i - 1], &moves[i]})
        ends.push_back({{FromUm(move->x_um + span.shift.x), FromUm(move->y_um + span.shift.y)},
                        FromUm(moves[i].width_um)});
    }
  }
  return ends;
}

}  // namespace

Polygon FootprintOf(std::span<const MoveSpan> program) {
  const std::vector<BeadEnd> ends = EndsOf(program);
  Polygon middles;
  middles.reserve(ends.size());
  for (const BeadEnd& end : ends) middles.push_back(end.place);
  const Polygon hull = ConvexHull(std::move(middles));
  Coord width_nm = 0;
  for (const BeadEnd& end : ends)
    if (end.width_nm > width_nm && std::ranges::find(hull, end.place) != hull.end())
      width_nm = end.width_nm;
  return ConvexSum(hull, DiscCover(width_nm / 2));
}

Polygon FirstLayerHull(const ProgramSummary& summary) {
  Polygon corners;
  for (const LayerSummary& layer : summary.layers)
    corners.insert(corners.end(), layer.footprint.begin(), layer.footprint.end());
  return ConvexHull(std::move(corners));
}

}  // namespace slicefarm::motion
