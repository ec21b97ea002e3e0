#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/cells/voronoi_tile.h"

namespace slicefarm::infill {

/// A stretch of a curve along cells' edges: from the middle of an edge over one of the two sides of
/// a doubled edge to the middle of another edge. Strands of a tile are repeated with it.
struct Strand {
  std::array<Vector2, 4> points;
  /// Where it goes on at either end: the end of which strand, and how many tiles aside that one is.
  struct Next {
    int32_t strand = 0;
    int32_t end = 0;
    int32_t step_u = 0;
    int32_t step_v = 0;
  };
  std::array<Next, 2> next;
};

/// Walks the edges of a tile's cells without lifting: in each vertex three edges meet, so one of
/// them has to be walked twice. Which ones, such that each vertex has one, is the perfect matching
/// of least length; its two lines lie side by side, as those of the rows of `honeycomb` do. All
/// strands of a tile are one curve: where the sides of doubled edges belong to different ones, the
/// two cross.
class StrandTile {
 public:
  /// REQUIRES: three edges meet in each vertex, and the tile is connected.
  explicit StrandTile(VoronoiTile tile);

  /// With the lines of a doubled edge `gap` apart, in tiles. Cost: O(n), n vertices: 10 ns each.
  std::vector<Strand> Strands(double gap) const;

  int Crossings() const { return crossings_; }
  const std::vector<bool>& Doubled() const { return doubled_; }  ///< by edge

 private:
  /// One line of a doubled edge. Half-edge 2 e runs along edge e, 2 e + 1 against it.
  struct Course {
    int32_t edge = 0;
    /// The half-edges that it comes from and goes to: one leaves the doubled edge's first vertex,
    /// the other its second one.
    std::array<int32_t, 2> ends{};
  };
  /// An end of a strand: a vertex, the way along the edge that leaves it, and how far along that
  /// edge, for each unit of the gap, the line turns to run beside the doubled one.
  struct Bend {
    Vector2 vertex = Vector2::Zero();
    Vector2 way = Vector2::Zero();
    double share_by_gap = 0;

    Vector2 At(double share) const {
      return {vertex.x() + share * way.x(), vertex.y() + share * way.y()};
    }
  };

  Vector2 Way(int32_t half) const;
  void MatchVertices();
  void LayCourses();
  void JoinCourses();
  void LinkStrands();
  void MeasureBends();

  VoronoiTile tile_;
  std::vector<std::array<int32_t, 3>> leaving_;  ///< half-edges, by vertex
  std::vector<bool> doubled_;
  std::vector<Course> courses_;  ///< two for each doubled edge, one after the other
  std::vector<Strand> strands_;  ///< by course, without points
  std::vector<std::array<Bend, 2>> bends_;
  int crossings_ = 0;
};

}  // namespace slicefarm::infill
