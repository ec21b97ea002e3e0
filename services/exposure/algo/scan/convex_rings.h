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

/// Insets of a convex polygon. Each inset moves the edges inwards. An edge that disappears in an
/// inset is removed for good. Therefore the distances must not decrease from call to call. Cost:
/// O(n) per call, n edges.
class ConvexInsets {
 public:
  /// Prepares the insets of `piece`, with coordinates in 1 / `scale` nm. REQUIRES: convex,
  /// counter-clockwise.
  ConvexInsets(const Polygon& piece, double scale);

  /// Returns the inset by `distance_nm`, counter-clockwise, or an empty ring if nothing is left.
  ConvexRing At(double distance_nm);

  /// Returns the distance of the deepest inset that is not empty, with an error of at most +1 um.
  /// Do not call At afterwards. Cost: O(n log(depth)), n edges.
  double Depth();

 private:
  /// Edge as a directed line. The polygon is to its left.
  struct Edge {
    Vector2 at = Vector2::Zero();
    Vector2 direction = Vector2::Zero();  ///< unit vector
  };
  std::vector<Edge> edges_;  ///< edges sorted by direction
};

/// Line along the middle of a thin convex polygon, halfway between its longest side and the corner
/// farthest from this side.
struct Spine {
  Vector2 from = Vector2::Zero(), to = Vector2::Zero();
  double width_nm = 0;  ///< width of the polygon, perpendicular to the line
};
/// Returns the spine halfway between the longest side and the corner farthest from it. REQUIRES: at
/// least three corners.
Spine SpineOf(const ConvexRing& ring);
/// Returns the line along which a spot of diameter `spot_nm` melts the polygon. In a polygon that
/// tapers, the line is nearer to the longest side than the middle, because it is longer there. The
/// spot still reaches the corner farthest from this side.
Spine SpineOf(const ConvexRing& ring, double spot_nm);

/// Parameters of the rings that fill a piece.
struct RingFill {
  double pitch_nm = 0;
  double first_nm = 0;  ///< distance from the piece's boundary to the first ring
  /// Smallest width of an unmelted area in the middle that gets a line, as a share of the pitch.
  double least_spine = 0.05;
  bool corners = false;  ///< true if rings reach into corners (corner_spurs.h)
  SpurFill spurs = {};
  /// Rings that melt some area twice; the choice differs in each layer (layer_shift.h). nullopt:
  /// all rings reach into corners, and the innermost ring overlaps itself or the line in the
  /// middle.
  std::optional<RingTurn> turn = std::nullopt;
  /// Boundary of the region that was cut into pieces. Its grid's reach is at least SpurReach and
  /// spine_gap_nm. Null: the piece is the whole region.
  const BorderGrid* border = nullptr;
  /// distance that a spine keeps from the boundary if no ring surrounds it
  double spine_gap_nm = 0;
};

/// Smallest depth of a piece, in pitches, at which RingFill::turn shifts its inner rings.
inline constexpr double kTurnedRings = 4;

/// Returns the rings of a convex piece from its boundary inwards, at the distances first_nm + k *
/// pitch_nm. The last element is the spine of the unmelted area in the middle (two points), if
/// there is one. With `fill.turn`, the inner rings of a piece at least kTurnedRings deep are
/// shifted outwards by less than a pitch. Coordinates of `piece` are in 1 / `scale` nm; the result
/// is rounded to nm.
std::vector<Polyline> ConvexRings(const Polygon& piece, double scale, const RingFill& fill);

}  // namespace slicefarm::exposure
