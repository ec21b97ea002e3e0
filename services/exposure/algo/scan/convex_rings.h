#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"
#include "services/exposure/algo/scan/border_grid.h"
#include "services/exposure/algo/scan/convex_ring.h"
#include "services/exposure/algo/scan/corner_spurs.h"
#include "services/exposure/algo/scan/layer_shift.h"

namespace slicefarm::exposure {

/// Insets of a convex polygon by moving its edges. Edges that vanish stay so in deeper ones, so
/// distances must not decrease from call to call. Cost: O(n) a call.
class ConvexInsets {
 public:
  /// REQUIRES: convex, counter-clockwise. Coordinates are in 1 / `scale` nm.
  ConvexInsets(const Polygon& piece, double scale);

  /// Counter-clockwise; empty if nothing is left.
  ConvexRing At(double distance_nm);

  /// Of the deepest inset of which something is left, and up to a micrometre more. REQUIRES: At is
  /// not called any more. Cost: O(n log(depth)).
  double Depth();

 private:
  /// A line; the polygon is on its left.
  struct Edge {
    Vector2 at = Vector2::Zero();
    Vector2 way = Vector2::Zero();  ///< of length 1
  };
  std::vector<Edge> edges_;  ///< by ascending direction
};

/// A line along the middle of a thin convex polygon, halfway between its longest side and what is
/// farthest from that.
struct Spine {
  Vector2 from = Vector2::Zero(), to = Vector2::Zero();
  double width_nm = 0;  ///< of the polygon, across
};
/// REQUIRES: three corners at least.
Spine SpineOf(const ConvexRing& ring);
/// The same to be melted by a spot: where the polygon tapers the line lies nearer to the longest
/// side, where it is longer, as far as the spot still reaches what is farthest.
Spine SpineOf(const ConvexRing& ring, double spot_nm);

/// How rings fill a piece.
struct RingFill {
  double pitch_nm = 0;
  double first_nm = 0;  ///< from the border to the first ring
  /// Narrower leftovers in the middle stay empty, as a share of the pitch.
  double least_spine = 0.05;
  bool corners = false;  ///< rings reach into corners (corner_spurs.h)
  SpurFill spurs = {};
  /// What is melted twice lies elsewhere in each layer (layer_shift.h); nullopt: all rings reach
  /// into corners, and the innermost overlaps itself or the line in the middle.
  std::optional<RingTurn> turn = std::nullopt;
  /// Of the region that was cut into pieces, with a reach of SpurReach and spine_gap_nm at least;
  /// null: the piece is all of it.
  const BorderGrid* border = nullptr;
  double spine_gap_nm = 0;  ///< from the border to spines without a ring around them
};

inline constexpr double kTurnedRings = 4;

/// Rings of a convex piece from its border inwards, at first + k * pitch, and the spine of what is
/// left in the middle (two points). With a turn, rings from one of them on are nearer by less than
/// a pitch, if the piece has room for kTurnedRings. Rounded to nm.
std::vector<Polyline> ConvexRings(const Polygon& piece, double scale, const RingFill& fill);

}  // namespace slicefarm::exposure
