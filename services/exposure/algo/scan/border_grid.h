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

/// Boundary of a region, stored in the squares of a grid. It tests if lines keep a distance from
/// the boundary. Each square stores the distance to the nearest square that contains boundary. For
/// most lines, the square at the line's middle decides the test. All other lines are followed from
/// square to square.
///
/// Distances are exact except for rounding of doubles, below a thousandth of a nanometre.
class BorderGrid {
 public:
  /// Builds the grid. reach_nm: the largest distance of later queries, >= 0. REQUIRES: the region
  /// is in canonical form, so that its rings do not cross by more than 2 nm. Cost: O(edges +
  /// squares).
  BorderGrid(const MultiPolygon& region, double reach_nm);

  /// Returns true if the whole segment ab is in the region, at least `distance_nm` from its
  /// boundary. REQUIRES: distance_nm <= reach_nm. Cost: O(1) far from the boundary.
  bool Keeps(Point a, Point b, double distance_nm) const;

  /// Returns the same as Keeps, but faster. REQUIRES: a is inside the region. Along a polyline,
  /// call Keeps for the first segment and KeepsOn for the next ones.
  bool KeepsOn(Point a, Point b, double distance_nm) const;

  /// Returns true if no point of the segment ab is outside of the region by more than `beyond_nm`.
  /// The test is for lines on the boundary itself, where rounding decides the side. REQUIRES: 0 <
  /// beyond_nm <= reach_nm. Cost: O(1) far from the boundary.
  bool Stays(Point a, Point b, double beyond_nm) const;

  /// Returns true if the boundary is nearer to p than `distance_nm`. REQUIRES: distance_nm <=
  /// reach_nm.
  bool IsNear(Point p, double distance_nm) const;

  /// Returns the longest part of the segment ab that is in the region and at least `distance_nm`
  /// from its boundary. Returns nullopt if there is no such part.
  std::optional<std::pair<Point, Point>> LongestRun(Point a, Point b, double distance_nm) const;

 private:
  /// Edge of the boundary. The region is to its left.
  struct Edge {
    Vector2 inward = Vector2::Zero();                  ///< unit vector perpendicular to the edge
    double offset = 0;                                 ///< offset of the edge's line along `inward`
    Vector2 a = Vector2::Zero(), b = Vector2::Zero();  ///< ends, relative to the grid's corner

    /// Returns the distance of p to the left of the edge's line.
    double LeftOf(Vector2 p) const { return Dot(inward, p) - offset; }
    /// Returns true if p and q are both at least `distance` before the edge's start, or both at
    /// least `distance` behind its end. This fast test decides most cases.
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
  /// Returns true if the segment ab keeps `distance_nm` from the boundary, on either side of it.
  /// `inside`: set to true if the search shows that the segment is inside.
  bool KeepsAlong(Vector2 a, Vector2 b, double distance_nm, bool& inside) const;
  bool IsInside(Vector2 p) const;
  bool IsNearEdge(Vector2 p, double distance_nm) const;
  bool RunsAlongEdge(Vector2 a, Vector2 b, double distance_nm) const;
  /// Returns true if the segment ab without its first and last `ends_nm` is inside. Returns false
  /// if the edges beside the segment do not decide this.
  bool IsInsideButEnds(Vector2 a, Vector2 b, double ends_nm) const;
  /// Returns true if all parts of the segment ab that are at least `distance_nm` from the boundary
  /// are inside.
  bool IsInsideWhereFar(Vector2 a, Vector2 b, double distance_nm) const;

  template <typename Visit>
  void ForEachSquare(const Edge& edge, double reach_nm, Visit visit) const;
  template <typename Visit>
  bool Follow(Vector2 a, Vector2 b, Visit visit) const;

  void ChooseSquares(double reach_nm);
  void SortEdges(double reach_nm);
  void FindInterior();

  std::vector<Edge> edges_;
  Box box_;
  int square_bits_ = 0;  ///< a square is 2^square_bits_ nm wide
  double square_ = 1;
  double per_nm_ = 1;  ///< squares per nm; exact, because it is a power of two
  int32_t columns_ = 0, rows_ = 0;
  std::vector<int32_t> begin_;  ///< index in items_ of the first item of each square
  std::vector<int32_t> items_;  ///< edges within reach of each square
  /// Distance of each square, in squares, to the nearest square that contains boundary or is
  /// outside. 0: the square itself contains boundary or is outside.
  std::vector<uint8_t> interior_;
};

}  // namespace slicefarm::exposure
