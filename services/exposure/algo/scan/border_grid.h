#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"
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

  /// The same where a is known to be inside: of a line, only the first piece need be asked where it
  /// is.
  bool KeepsOn(Point a, Point b, double distance_nm) const;

  /// Whether no point of the segment ab lies outside of the region by more than `beyond_nm`: for
  /// lines along the border itself, where roundings decide the side.
  /// REQUIRES: 0 < beyond_nm <= reach. Cost: O(1) far from the border.
  bool Stays(Point a, Point b, double beyond_nm) const;

  /// Whether the border comes nearer to p than that. REQUIRES: distance_nm <= reach.
  bool IsNear(Point p, double distance_nm) const;

  /// The longest run of the segment ab that keeps away that far; nullopt: none does.
  std::optional<std::pair<Point, Point>> LongestRun(Point a, Point b, double distance_nm) const;

 private:
  /// An edge of the border; the region is to its left.
  struct Edge {
    Vector2 inward = Vector2::Zero();                  ///< of length 1, at a right angle
    double offset = 0;                                 ///< of the edge's line along it
    Vector2 a = Vector2::Zero(), b = Vector2::Zero();  ///< from the grid's corner

    /// How far p lies to the left of the edge's line.
    double LeftOf(Vector2 p) const { return Dot(inward, p) - offset; }
    /// Whether both places lie that far before the edge, or both behind it: a first look that
    /// settles most.
    bool AreBeside(Vector2 p, Vector2 q, double distance) const {
      return std::max(Cross(p - a, inward), Cross(q - a, inward)) <= -distance ||
             std::min(Cross(p - b, inward), Cross(q - b, inward)) >= distance;
    }
  };
  struct Square {
    int32_t column = 0, row = 0;
  };

  bool Has(Point p) const {
    return p.x >= box_.min.x && p.x <= box_.max.x && p.y >= box_.min.y && p.y <= box_.max.y;
  }
  Square At(Vector2 p) const {
    return {std::clamp(static_cast<int32_t>(p.x() * per_nm_), 0, columns_ - 1),
            std::clamp(static_cast<int32_t>(p.y() * per_nm_), 0, rows_ - 1)};
  }
  Square SquareOf(Point p) const {
    return {static_cast<int32_t>((p.x - box_.min.x) >> square_bits_),
            static_cast<int32_t>((p.y - box_.min.y) >> square_bits_)};
  }
  size_t IndexOf(Square s) const { return static_cast<size_t>(s.row) * columns_ + s.column; }
  Vector2 Local(Point p) const {
    return {static_cast<double>(p.x - box_.min.x), static_cast<double>(p.y - box_.min.y)};
  }
  bool IsFarFromBorder(Point a, Point b) const;
  /// Whether a segment keeps away; `inside`: whether it was seen where it is.
  bool KeepsAlong(Vector2 a, Vector2 b, double distance_nm, bool& inside) const;
  bool IsInside(Vector2 p) const;
  bool IsNearEdge(Vector2 p, double distance_nm) const;
  bool RunsAlongEdge(Vector2 a, Vector2 b, double distance_nm) const;
  /// Whether of the segment ab all but its ends, that long, is inside; false if that takes more
  /// than a look at the edges beside it.
  bool IsInsideButEnds(Vector2 a, Vector2 b, double ends_nm) const;
  /// Whether of the segment ab all that is at least that far from the border is inside.
  bool IsInsideWhereFar(Vector2 a, Vector2 b, double distance_nm) const;

  template <typename Visit>
  void ForEachSquare(const Edge& edge, double reach_nm, Visit visit) const;
  template <typename Visit>
  bool Follow(Vector2 a, Vector2 b, Visit visit) const;

  void ChooseSquares(double reach_nm);
  void SortEdges(double reach_nm);
  void FindRoom();

  std::vector<Edge> edges_;
  Box box_;
  int square_bits_ = 0;  ///< a square is 2^bits nm wide
  double square_ = 1;
  double per_nm_ = 1;  ///< squares; exact, as it is a power of two
  int32_t columns_ = 0, rows_ = 0;
  std::vector<int32_t> begin_;  ///< in items_, by square
  std::vector<int32_t> items_;  ///< edges within reach of the square
  /// By square: how many squares it is to the nearest one with border, or outside; 0: it is one.
  std::vector<uint8_t> room_;
};

}  // namespace slicefarm::exposure
