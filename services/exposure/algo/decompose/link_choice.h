#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "common/geometry/point.h"
#include "common/geometry/vector.h"
#include "services/exposure/algo/decompose/cut_region.h"
#include "services/exposure/algo/decompose/exact_vector.h"

namespace slicefarm::exposure {

/// Cosine of 30 degrees; a cut at a smaller angle is sharp.
constexpr double kCosine30 = 0.86602540378443865;

/// End of a cut from a reflex corner.
struct Link {
  CornerIndex end;  ///< the end corner; if the cut ends inside an edge, the start of this edge
  /// the end point inside an edge, if the cut does not end at a corner
  std::optional<Point> extra = {};
  double cosine = 0;  ///< cosine of the smallest angle between the cut and an edge, at either end
  /// Cosine of the smallest angle between the cut and an edge at its end corner. Only set if the
  /// rule of 30 degrees has chosen this corner.
  std::optional<double> ruled_cosine = {};
};

/// Search for the best end of a cut from a reflex corner P, after Bian et al. 2005.
///
/// Region A is the region between the extensions of P's two edges. A cut into A leaves less than
/// 180 degrees on both sides. Corners in A that P sees are preferred in this order:
///   1. reflex corners that have P in their own region A, because one cut serves both corners;
///   2. other reflex corners;
///   3. convex corners at which the cut makes no angle below 30 degrees.
///
/// Within a rank, corners on the extension of an edge at P are first, the nearest of these corners
/// first of all. With such a cut, the ring has one bend less at P. Then corners follow by
/// weight |cos a - cos b|, smallest first. Here a and b are the cut's angles with the edges, and
/// the weight is summed over both ends. A cut to a reflex corner with an angle below 1 degree is
/// not used: it would cut slivers off a wall that is straight except for rounding. If there is no
/// corner, the cut follows the bisector of A to the boundary.
///
/// All decisions about the side of a line are exact. A cut never passes through a corner. Cost:
/// O(n), n points of the region, and O(edges in A) for each tested candidate. The memory is reused
/// in each call.
class LinkChoice {
 public:
  /// Returns the best end of the cut from corner `from`. Returns nullopt if the corner sees no
  /// possible end, which cannot happen if the region's rings do not cross.
  ///
  /// variant: 0 for the best end. 1 and 2 choose the next best ends of the same rank that make no
  /// angle below 30 degrees. If the best cut ends at no corner, or if a convex corner is the only
  /// candidate, 1 and 2 choose a cut beside the bisector.
  std::optional<Link> Choose(const CutRegion& region, CornerIndex from, int32_t variant = 0);

 private:
  struct Edge {
    Vector2 from = Vector2::Zero(), to = Vector2::Zero();  ///< ends relative to P
    int origin_side = 0;  ///< side of the edge's line on which P is: +1 left, -1 right
    CornerIndex index;
  };
  struct Candidate {
    int rank = 0;
    bool turns = true;      ///< false if the candidate is on the extension of an edge at P
    double weight = 0;      ///< weight, only of candidates with `turns`
    double cosine = 0;      ///< cosine of the smallest angle at either end
    double end_cosine = 0;  ///< cosine of the smallest angle at the candidate's end
    Vector2 at = Vector2::Zero();
    CornerIndex index;

    auto Key() const {
      return std::tuple(rank, turns, weight, Dot(at, at), index.ring, index.point);
    }
  };

  void Collect(const CutRegion& region, CornerIndex from);
  void AddCandidate(const Polygon& ring, CornerIndex index, Vector2 at, bool turns);
  bool Sees(Vector2 at);
  Link LinkTo(const Candidate& candidate) const;
  Link InsteadOf(const Candidate& best, const CutRegion& region, int32_t variant);
  std::optional<Link> BisectorLink(const CutRegion& region, int32_t variant);
  std::optional<Link> LinkAlong(const CutRegion& region, double share);

  Point origin_;                                          ///< the corner P
  Vector2 in_ = Vector2::Zero(), out_ = Vector2::Zero();  ///< edges of P, towards P and away from P
  /// Edges that may intersect A. Edges that hid a candidate recently are near the front, so that
  /// the next test finds them early.
  std::vector<Edge> edges_;
  std::vector<Candidate> candidates_;
};

}  // namespace slicefarm::exposure
