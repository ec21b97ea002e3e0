#include "services/motion/algo/toolpath/edge_moves.h"

#include <algorithm>
#include <cmath>

#include "common/gcode/gcode_text.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Returns the start position of the program, then its moves.
std::vector<EdgeMove> AllMoves(std::span<const MoveSpan> spans, MoveWalk& walk) {
  std::vector<EdgeMove> moves = {walk.at()};
  for (const MoveSpan& span : spans)
    for (size_t i = span.first; i < span.last; ++i) {
      moves.push_back(walk.Go(span.path->moves[i], span.shift));
      moves.back().copy = i < span.FirstOwn() ? span.travel_copy : span.copy;
    }
  return moves;
}

}  // namespace

const EdgeMove& MoveWalk::Go(const Move& move, ShiftUm shift) {
  if (MovesInPlane(move.kind)) {
    at_.x_um = move.x_um + shift.x;
    at_.y_um = move.y_um + shift.y;
  }
  if (move.kind == MoveKind::kLift || move.kind == MoveKind::kTravel) at_.z_um = move.z_um;
  at_.filament = move.filament;
  at_.feed_rate = move.feed_rate;
  at_.feature = move.feature;
  at_.jerk_mm_s = move.jerk_mm_s;
  const double own = move.acceleration_mm_s2;
  at_.acceleration_mm_s2 = own > 0 ? own : acceleration_mm_s2_;
  const bool of_filament = move.kind == MoveKind::kRetract || move.kind == MoveKind::kRestart;
  if (own > 0 && !of_filament) acceleration_mm_s2_ = own;
  return at_;
}

std::optional<KinematicMove> ToKinematic(const EdgeMove& before, const EdgeMove& move,
                                         double set_mm_s2) {
  const double x = static_cast<double>(move.x_um - before.x_um) / kUmPerMm;
  const double y = static_cast<double>(move.y_um - before.y_um) / kUmPerMm;
  const double z = static_cast<double>(move.z_um - before.z_um) / kUmPerMm;
  const double e = static_cast<double>(move.filament) / kFilamentUnitsPerMm;
  double length = std::sqrt(x * x + y * y + z * z);
  if (length == 0) length = std::abs(e);
  if (length == 0) return std::nullopt;
  const double scale = 1 / length;
  return KinematicMove{length,
                       {x * scale, y * scale, z * scale, e * scale},
                       SpeedOf(move.feed_rate),
                       move.acceleration_mm_s2 > 0 ? move.acceleration_mm_s2 : set_mm_s2};
}

bool Prints(const EdgeMove& before, const EdgeMove& move) {
  return move.filament > 0 && (move.x_um != before.x_um || move.y_um != before.y_um);
}

LayerEdges EdgesOf(std::span<const MoveSpan> spans) {
  LayerEdges edges;
  if (spans.empty()) return edges;
  MoveWalk walk({.z_um = spans.front().path->start_z_um}, 0);
  const std::vector<EdgeMove> moves = AllMoves(spans, walk);
  const auto at = [&](size_t i) { return moves.begin() + static_cast<std::ptrdiff_t>(i); };
  const size_t entry = spans.front().path->approach + 1;  // first move after the start point
  edges.approach = static_cast<int32_t>(entry);
  edges.head.assign(at(0), at(std::min(moves.size(), entry + 1 + kEdgeMoves)));
  const size_t last = moves.size() - 1;
  edges.tail.assign(at(std::max(entry, last > kEdgeMoves ? last - kEdgeMoves : 0)), moves.end());
  edges.acceleration_mm_s2 = walk.acceleration_mm_s2();
  return edges;
}

}  // namespace slicefarm::motion
