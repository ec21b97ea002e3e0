#pragma once

#include <optional>
#include <span>
#include <vector>

#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// Returns the area of the box as a region.
MultiPolygon RegionOf(const Box& box);

/// Search for short travel paths inside a region that keep away from the region's boundary. The
/// search uses a visibility graph.
///
/// A lane is the boundary's inset by 1.5 clearances, with few points. The nozzle stays in the area
/// that the lanes enclose. Only a start or end point outside this area is joined to it by a
/// straight line. The nodes of the graph are the corners of the lanes at which a path can bend. Two
/// nodes are linked if the line between them stays inside the lanes and a tight string could follow
/// it. A line of sight is computed when it is first needed, and is then cached. Source: T.
/// Lozano-Perez, M. A. Wesley, "An Algorithm for Planning Collision-Free Paths among Polyhedral
/// Obstacles", CACM 22 (1979).
class TravelPaths {
 public:
  /// Builds the lanes of the region. REQUIRES: clearance_nm > 0.
  TravelPaths(const MultiPolygon& region, Coord clearance_nm);

  /// Returns true if the line ab stays in the region and keeps the clearance. Within 3 clearances
  /// of its ends the line may be nearer to the boundary.
  bool IsClear(Point a, Point b) const;

  /// Returns the corners of a short path from a to b. Returns nothing if the path would be longer
  /// than `longest_nm`, or if the budget (in lines of sight) is spent. If the lanes enclose a and
  /// b, the path is the shortest one inside the lanes, to within some micrometres. REQUIRES: a and
  /// b are in the region or beside it.
  std::optional<std::vector<Point>> Find(Point a, Point b, double longest_nm, WorkBudget& budget);

  /// Returns the point nearest to p that keeps the clearance. p is on the region's boundary.
  /// Returns nothing if that point is 4 clearances away or more.
  std::optional<Point> FromEdge(Point p) const;

 private:
  /// Corner of a lane, with the corners before and after it on the ring.
  struct Node {
    Point at, before, after;
  };
  struct Link {
    uint32_t to;
    double length;
  };
  class Search;

  void AddNodes(const Polygon& ring);
  /// Returns p if the lanes enclose it, else the point inside the lanes nearest to p. Returns
  /// nothing if that point is 4 clearances away or more.
  std::optional<Point> Indoors(Point p) const;
  /// Returns the point nearest to p among the points of lanes for which `will_do` is true. The
  /// returned point is slightly inside the lane, so that a path can lead along the lane from there.
  /// Returns nothing if the point is 4 clearances away or more.
  template <typename WillDo>
  std::optional<Point> OnLane(Point p, WillDo will_do) const;
  bool Sees(Point a, Point b) const { return !border_.Meets(a, b); }
  const std::vector<Link>& LinksOf(uint32_t node, WorkBudget& budget);

  Coord clearance_;
  EdgeStrips edge_;    ///< boundary of the region
  EdgeStrips border_;  ///< lanes grown by 5 um; a path along a lane does not touch them
  EdgeStrips lane_;
  std::vector<Polygon> lanes_;
  std::vector<Node> nodes_;
  /// Links of each node, indexed by node; computed at first use.
  std::vector<std::optional<std::vector<Link>>> links_;
};

}  // namespace slicefarm::ordering
