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

constexpr double kCosine30 = 0.86602540378443865;  ///< cuts at a smaller angle are sharp

/// Where a cut from a reflex corner ends.
struct Link {
  CornerIndex end;                  ///< the corner; or the start of the edge that is divided
  std::optional<Point> extra = {};  ///< the place on that edge
  double cosine = 0;                ///< of the least angle of the cut with an edge, at either end
  /// The same at its end alone, where the rule of 30 degrees has chosen it.
  std::optional<double> ruled_cosine = {};
};

/// Finds the best end of a cut from a reflex corner P, after Bian et al. 2005.
///
/// Region A is what lies between the extensions of P's two edges: a cut into it leaves less than
/// 180 degrees on both sides. Of the corners in A that P sees are preferred
///   1. reflex ones that have P in their own region A, as one cut does for both;
///   2. other reflex ones;
///   3. convex ones at which the cut makes no angle below 30 degrees;
/// among these, those on the extension of an edge at P (rings have a turn less there), the nearest
/// first, then those of least weight |cos a - cos b|, a and b the cut's angles with the edges,
/// summed over both ends.
/// A cut to a reflex corner that makes an angle below 1 degree counts as none: along a wall that is
/// straight but for rounding it would part off slivers.
/// If there is none, the cut runs along the bisector of A to the border.
///
/// All tests of sides are exact. A cut never passes another corner. Cost: O(n), and O(edges in A)
/// for each candidate that is tried. Keeps its memory from call to call.
class LinkChoice {
 public:
  /// nullopt: the corner sees no place to go to, which does not happen in regions whose rings do
  /// not cross.
  ///
  /// variant: 0 for the best one; 1, 2 for the next ones of the same rank, as long as they make no
  /// angle below 30 degrees, for cuts beside the bisector, and for such where a convex corner is
  /// the only one.
  std::optional<Link> Choose(const CutRegion& region, CornerIndex from, int32_t variant = 0);

 private:
  struct Edge {
    Vector2 from = Vector2::Zero(), to = Vector2::Zero();  ///< relative to P
    int origin_side = 0;                                   ///< on which side of the edge P lies
    CornerIndex index;
  };
  struct Candidate {
    int rank = 0;
    bool turns = true;      ///< is not on the extension of an edge at P
    double weight = 0;      ///< of those that turn
    double cosine = 0;      ///< of the least angle, at either end
    double end_cosine = 0;  ///< at its end
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

  Point origin_;                                          ///< P
  Vector2 in_ = Vector2::Zero(), out_ = Vector2::Zero();  ///< P's edges, towards P and away from it
  std::vector<Edge> edges_;  ///< those that may reach into A; the last ones to block come first
  std::vector<Candidate> candidates_;
};

}  // namespace slicefarm::exposure
