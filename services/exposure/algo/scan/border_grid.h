#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// The border of a region by the squares of a grid, to tell whether lines keep away from it. Most
/// lines are told by one look at the square in their middle, which knows how far it is from there
/// to the nearest square with border; the rest is followed from square to square.
///
/// Distances are exact but for roundings of doubles, below a thousandth of a nanometre.
class BorderGrid {
 public:
  /// reach_nm: the greatest distance that will be asked for, >= 0. The region is in canonical form:
  /// its rings do not cross, as far as 2 nm. Cost: O(edges + squares).
  BorderGrid(const MultiPolygon& region, double reach_nm);

  /// Whether all of the segment ab lies in the region, and no nearer to its border than that.
  /// REQUIRES: distance_nm <= reach. Cost: O(1) far from the border.
  bool Keeps(Point a, Point b, double distance_nm) const;

  /// Whether the border comes nearer to p than that. REQUIRES: distance_nm <= reach.
  bool IsNear(Point p, double distance_nm) const;

  /// The longest run of the segment ab that keeps away that far; nullopt: none does.
  std::optional<std::pair<Point, Point>> LongestRun(Point a, Point b, double distance_nm) const;

 private:
  /// An edge of the border; the region is to its left.
  struct Edge {
    PlaneVector a, b;    ///< from the grid's corner
    PlaneVector inward;  ///< of length 1, at a right angle
  };
  /// From a place to where it may be, in squares along both axes.
  struct Square {
    int32_t column = 0, row = 0;
  };

  bool Has(Point p) const;
  Square At(PlaneVector p) const;
  size_t IndexOf(Square s) const { return static_cast<size_t>(s.row) * columns_ + s.column; }
  PlaneVector Local(Point p) const {
    return {static_cast<double>(p.x - box_.min.x), static_cast<double>(p.y - box_.min.y)};
  }
  /// How far any place in p's square is from squares with border at least; below 0: p is in one.
  Coord RoomAt(Point p) const;
  bool KeepsAlong(PlaneVector a, PlaneVector b, double distance_nm) const;
  bool IsInside(PlaneVector p) const;

  template <typename Visit>
  void ForEachSquare(const Edge& edge, double reach_nm, Visit visit) const;
  template <typename Visit>
  bool Follow(PlaneVector a, PlaneVector b, Visit visit) const;

  void ChooseSquares(double reach_nm);
  void SortEdges(double reach_nm);
  void FindRoom();

  std::vector<Edge> edges_;
  Box box_;
  int square_bits_ = 0;  ///< a square is 2^bits nm wide
  double square_ = 1;
  int32_t columns_ = 0, rows_ = 0;
  std::vector<int32_t> begin_;  ///< in items_, by square
  std::vector<int32_t> items_;  ///< edges within reach of the square
  /// By square: how many squares it is to the nearest one with border, or outside; 0: it is one.
  std::vector<uint8_t> room_;
};

}  // namespace slicefarm::exposure
