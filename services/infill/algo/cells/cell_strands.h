#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "services/infill/algo/cells/voronoi_tile.h"

namespace slicefarm::infill {

/// A stretch of a curve along cells' edges: from the middle of an edge over one of the two sides of
/// a doubled edge to the middle of another edge. Strands of a tile are repeated with it.
struct Strand {
  std::array<Vec, 4> points;
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

  /// With the lines of a doubled edge `gap` apart, in tiles.
  std::vector<Strand> Strands(double gap) const;

  int Crossings() const { return crossings_; }
  const std::vector<bool>& Doubled() const { return doubled_; }  ///< by edge

 private:
  /// Half-edge 2 e runs along edge e, 2 e + 1 against it.
  struct Course {
    int32_t from = 0;   ///< the half-edge that leaves the doubled edge's first vertex
    int32_t to = 0;     ///< and the one that leaves its second vertex
    int32_t along = 0;  ///< the doubled edge, as a half-edge
  };

  Vec Way(int32_t half) const;
  Vec Corner(Vec vertex, int32_t half, int32_t along, double gap) const;
  void MatchVertices();
  void LayCourses();
  void JoinCourses();

  VoronoiTile tile_;
  std::vector<std::array<int32_t, 3>> leaving_;  ///< half-edges, by vertex
  std::vector<bool> doubled_;
  std::vector<Course> courses_;  ///< two for each doubled edge, one after the other
  int crossings_ = 0;
};

}  // namespace slicefarm::infill
