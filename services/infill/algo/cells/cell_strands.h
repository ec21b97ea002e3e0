#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/cells/voronoi_tile.h"

namespace slicefarm::infill {

/// Part of the curve of a StrandTile: from the middle of a cell's edge, along one line of a doubled
/// edge, to the middle of another edge. The strands of a tile repeat with the tile. Positions are
/// in sides of the tile.
struct Strand {
  std::array<Vector2, 4> points;
  /// Continuation at one end of a strand: the index of the next strand, the end (0 or 1) at which
  /// it is entered, and its offset in tiles.
  struct Next {
    int32_t strand = 0;
    int32_t end = 0;
    int32_t step_u = 0;
    int32_t step_v = 0;
  };
  std::array<Next, 2> next;
};

/// Closed walk along all edges of a tile's cells, without a travel. Three edges meet in each
/// vertex, so the walk uses one of them twice. These doubled edges are the perfect matching of the
/// vertices with the smallest total length. The two lines of a doubled edge are side by side, like
/// the shared edges of `honeycomb`. All strands of a tile form one curve: if the two lines of a
/// doubled edge would belong to different curves, they cross, which joins the two curves.
class StrandTile {
 public:
  /// Computes the walk. REQUIRES: three edges meet in each vertex, and the tile is connected.
  explicit StrandTile(VoronoiTile tile);

  /// Returns the strands. `gap`: distance between the two lines of a doubled edge, in sides of the
  /// tile. Cost: O(n), n vertices: 10 ns per vertex.
  std::vector<Strand> Strands(double gap) const;

  /// Returns the number of doubled edges with two lines that cross each other.
  int Crossings() const { return crossings_; }
  /// Returns for each edge, by its index, true if it is doubled.
  const std::vector<bool>& Doubled() const { return doubled_; }

 private:
  /// One line of a doubled edge. Half-edge 2e leads along edge e in the edge's direction, half-edge
  /// 2e + 1 in the opposite direction.
  struct Course {
    int32_t edge = 0;
    /// Half-edges at the two ends of the line: the first leaves the doubled edge's first vertex,
    /// the second leaves its second vertex.
    std::array<int32_t, 2> ends{};
  };
  /// Bend between a doubled edge and a single edge: the end of a strand's part beside the doubled
  /// edge. It is on the edge that leaves `vertex` in the direction `direction`. `share_by_gap`: its
  /// distance from the vertex along this edge, per unit of the gap.
  struct Bend {
    Vector2 vertex = Vector2::Zero();
    Vector2 direction = Vector2::Zero();
    double share_by_gap = 0;

    Vector2 At(double share) const {
      return {vertex.x() + share * direction.x(), vertex.y() + share * direction.y()};
    }
  };

  Vector2 DirectionOf(int32_t half) const;
  void MatchVertices();
  void LayCourses();
  void JoinCourses();
  void LinkStrands();
  void MeasureBends();

  VoronoiTile tile_;
  std::vector<std::array<int32_t, 3>> leaving_;  ///< half-edges that leave each vertex
  std::vector<bool> doubled_;
  std::vector<Course> courses_;  ///< two for each doubled edge, one after the other
  std::vector<Strand> strands_;  ///< strands without points, indexed by course
  std::vector<std::array<Bend, 2>> bends_;
  int crossings_ = 0;
};

}  // namespace slicefarm::infill
