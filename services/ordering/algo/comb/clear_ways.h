#pragma once

#include <optional>
#include <span>
#include <vector>

#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// A region that is a box.
MultiPolygon RegionOf(const Box& box);

/// Short ways inside a region that keep off its edge, by a graph of visibility.
///
/// The nozzle keeps off the edge by more than the clearance: it stays between lanes, which are
/// insets of the edge of few points. Only places that lie closer to the edge are left, and come to,
/// straight. The graph's nodes are the lanes' corners that the way can bend around; two are joined
/// if they see each other and a string pulled tight could run along the line between them. Lines of
/// sight are looked at when they are first asked for, and kept.
/// Source: T. Lozano-Perez, M. A. Wesley, "An Algorithm for Planning Collision-Free Paths among
/// Polyhedral Obstacles", CACM 22 (1979).
class ClearWays {
 public:
  /// REQUIRES: clearance_nm > 0.
  ClearWays(const MultiPolygon& region, Coord clearance_nm);

  /// Whether ab stays in the region and keeps the clearance, but near its ends.
  bool IsClear(Point a, Point b) const;

  /// The corners of a short way from a to b, or nothing if there is none of at most `longest_nm` or
  /// the budget, in lines of sight, is spent. It is the shortest between the lanes, to some
  /// micrometres, if a and b lie between them. REQUIRES: a and b lie in the region or beside it.
  std::optional<std::vector<Point>> Find(Point a, Point b, double longest_nm, WorkBudget& budget);

  /// The place between the lanes nearest to p, which lies on the edge; nothing if it is far.
  std::optional<Point> FromEdge(Point p) const;

 private:
  /// A corner, and those before and after it on its ring.
  struct Node {
    Point at, before, after;
  };
  struct Link {
    uint32_t to;
    double length;
  };
  class Search;

  void AddNodes(const Polygon& ring);
  /// The place nearest to p between the lanes; nothing if it is far away.
  std::optional<Point> Indoors(Point p) const;
  /// A hair inside the nearest place on a lane of those that will do: a string can run from there
  /// along the lane. Nothing if it is far away.
  template <typename WillDo>
  std::optional<Point> OnLane(Point p, WillDo will_do) const;
  bool Sees(Point a, Point b) const { return !border_.Meets(a, b); }
  const std::vector<Link>& LinksOf(uint32_t node, WorkBudget& budget);

  Coord clearance_;
  EdgeStrips edge_;             ///< of the region
  EdgeStrips border_;           ///< a hair beyond the lanes
  EdgeStrips lane_;
  std::vector<Polygon> lanes_;
  std::vector<Node> nodes_;
  std::vector<std::optional<std::vector<Link>>> links_;  ///< by node, once asked for
};

}  // namespace slicefarm::ordering
