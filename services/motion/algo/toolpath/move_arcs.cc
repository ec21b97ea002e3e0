#include "services/motion/algo/toolpath/move_arcs.h"

#include <vector>

#include "common/geometry/arc_fit.h"

namespace slicefarm::motion {
namespace {

/// Returns true if two moves have the same bead, so that one arc may replace both.
bool SameBead(const Move& a, const Move& b) {
  return a.on_arc && b.on_arc && a.kind == MoveKind::kPrint && b.kind == MoveKind::kPrint &&
         a.feature == b.feature && a.rest == b.rest && a.width_um == b.width_um &&
         a.height_um == b.height_um && a.z_um == b.z_um && a.feed_rate == b.feed_rate &&
         a.acceleration_mm_s2 == b.acceleration_mm_s2;
}

/// Adds the arcs of the moves [first, last), which have the same bead.
void AddArcs(size_t first, size_t last, Toolpath& path) {
  std::vector<PointUm> points;
  points.reserve(last - first + 1);
  for (size_t i = first - 1; i < last; ++i)
    points.push_back({path.moves[i].x_um, path.moves[i].y_um});
  size_t at = 0;
  for (const CurvePiece& piece : FitArcs(points)) {
    if (piece.is_arc)
      path.arcs.push_back({first + at, first + piece.last, piece.centre, piece.clockwise});
    at = piece.last;
  }
}

}  // namespace

void FindArcs(Toolpath& path) {
  path.arcs.clear();
  for (size_t i = 1; i < path.moves.size();) {
    size_t end = i + 1;
    if (path.moves[i].z_um == path.moves[i - 1].z_um)
      while (end < path.moves.size() && SameBead(path.moves[i], path.moves[end])) ++end;
    if (end - i > 1) AddArcs(i, end, path);
    i = end;
  }
}

}  // namespace slicefarm::motion
