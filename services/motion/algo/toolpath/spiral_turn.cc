#include "services/motion/algo/toolpath/spiral_turn.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "common/geometry/rings/loop_point.h"

namespace slicefarm::motion {
namespace {

/// Longest piece with a changing flow.
constexpr double kRampPieceNm = 1e6;
/// Largest distance to the turn below, in beads, at which a turn is blended with it. At a larger
/// distance the blended bead would rest on nothing.
constexpr double kNearWidths = 4;

/// Points of a loop, with their positions along it as shares of its length.
class Loop {
 public:
  explicit Loop(const Path& path) : path_(path), length_nm_(PathLength(path)) {}

  /// Calls visit(point, share) for each point after the start, including the start again at the
  /// end. Edges are divided so that no two points are farther apart than `longest_nm`; 0: not
  /// divided.
  template <typename Visit>
  void ForEach(double longest_nm, const Visit& visit) const {
    double along = 0;
    for (size_t i = 0; i < path_.points.size(); ++i) {
      const Point from = path_.points[i], to = path_.points[(i + 1) % path_.points.size()];
      const double edge = Distance(from, to);
      if (edge <= 0) continue;
      const int pieces = longest_nm > 0 ? static_cast<int>(std::ceil(edge / longest_nm)) : 1;
      for (int k = 1; k <= pieces; ++k)
        visit(k == pieces ? to : PointBetween(from, to, static_cast<double>(k) / pieces),
              std::min(1.0, (along + edge * k / pieces) / length_nm_));
      along += edge;
    }
  }

 private:
  const Path& path_;
  const double length_nm_;
};

}  // namespace

std::vector<TurnPiece> TurnOf(const Path& path, const SpiralTurn& turn, const MultiPolygon& below,
                              const SpiralMotion& options) {
  const Coord width_nm = path.widths_nm.front();
  const double reach_nm = options.reach_nm > 0 ? static_cast<double>(options.reach_nm)
                                               : kNearWidths * static_cast<double>(width_nm);
  const auto between = [](double from, double to, double share) {
    return from + (to - from) * share;
  };
  const std::optional<Polygon> turn_below =
      turn.blends && turn.from ? SpiralLoop(below, width_nm) : std::nullopt;
  const auto placed = [&](Point point, double share) {
    if (!turn_below) return point;
    const Point under = NearestLoopPoint(*turn_below, point).at;
    const bool near = Distance(point, under) <= reach_nm;
    return near ? PointBetween(under, point, share) : point;
  };
  const Loop loop(path);
  std::vector<TurnPiece> pieces;
  const bool first = !turn.from;
  double last_share = 0;
  loop.ForEach(first ? kRampPieceNm : 0, [&](Point point, double share) {
    const double middle = (last_share + share) / 2;
    pieces.push_back(
        {placed(point, share), share, first ? between(options.start_flow, 1, middle) : 1});
    last_share = share;
  });
  if (!turn.last) return pieces;
  last_share = 0;
  loop.ForEach(kRampPieceNm, [&](Point point, double share) {
    pieces.push_back({point, 1, between(1, options.end_flow, (last_share + share) / 2)});
    last_share = share;
  });
  return pieces;
}

}  // namespace slicefarm::motion
