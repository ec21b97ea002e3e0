#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing {

/// The section of a mesh in one plane. Matter lies left of the lines.
struct Section {
  std::vector<Polygon> loops;    ///< closed
  std::vector<Polyline> chains;  ///< begin and end where the surface does
};

/// Memory that a thread reuses from layer to layer.
struct SweepScratch {
  std::vector<uint32_t>
      segment_of_face;          ///< valid for the faces of the layer only, so never cleared
  std::vector<Point> ends;      ///< by segment
  std::vector<uint32_t> exits;  ///< by segment: the half-edge across the rising edge
  std::vector<uint8_t> marks;   ///< by segment
  std::vector<Point> line;
};

/// Cuts a mesh by many horizontal planes.
///
/// One rule decides everything: a vertex is above a plane iff z_vertex >= z_plane. A face is in a
/// layer iff it has a vertex above and one not above, so zmin < z <= zmax; it is then crossed
/// through exactly two edges, and so is its neighbour over each of them: horizontal faces drop out
/// and vertices on the plane need no special case.
///
/// Vertices get the number of planes that they are above of; faces are sorted into layers by
/// counting; in a layer a face gives one segment, whose end is where the edge that rises crosses
/// the plane, and the next segment is that of the face on the other side of the edge. Nothing is
/// ever looked up by position. A crossing is interpolated from the lower end of its edge to the
/// upper one in integers and rounded to the nearest nm, so it depends on these two points and the
/// plane alone.
///
/// Units: nm. The planes ascend. The mesh lies within 32 bits and must outlive the sweep.
/// Cost: O(faces + segments), 4 bytes a segment.
class Sweep {
 public:
  /// `other_points`: the segments of the job's parts that were prepared before. Errors:
  /// MESH_TOO_LARGE if a layer, or all together, have more segments than limits.h allows.
  static absl::StatusOr<Sweep> Prepare(const ConnectedMesh& mesh, std::span<const Coord> planes_nm,
                                       int64_t other_points = 0);

  /// The section in plane `layer`. Repeated points are left out, loops of less than three points
  /// too. Which loop comes first and where it starts follows the order of the triangles. Safe to
  /// call from many threads, each with its own scratch.
  Section Cut(size_t layer, SweepScratch& scratch) const;

  int64_t segments() const { return static_cast<int64_t>(faces_.size()); }
  int64_t segments(size_t layer) const {
    return static_cast<int64_t>(layer_starts_[layer + 1] - layer_starts_[layer]);
  }

 private:
  /// A vertex and the number of planes at or below it: it is above plane k iff k < level.
  struct LeveledVertex {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;
    uint32_t level = 0;
  };

  Sweep(const ConnectedMesh& mesh, std::span<const Coord> planes_nm);
  absl::Status SortFacesIntoLayers(int64_t other_points);
  Point Crossing(uint32_t half_edge, Coord z_nm) const;
  void PrefetchFace(uint32_t face, SweepScratch& scratch) const;
  void PrefetchCorners(uint32_t face) const;
  /// One segment a face, in the order of `faces`.
  void CutFaces(std::span<const uint32_t> faces, size_t layer, SweepScratch& scratch) const;
  /// Bit i is set if corner i lies in or above the plane of the layer.
  unsigned Above(const Triangle& t, size_t layer) const {
    return (vertices_[t[0]].level > layer) | (vertices_[t[1]].level > layer) << 1 |
           (vertices_[t[2]].level > layer) << 2;
  }
  Polyline Chain(uint32_t first, uint32_t face, size_t layer, SweepScratch& scratch) const;
  Polygon Loop(uint32_t first, SweepScratch& scratch) const;
  /// Appends the ends of `first` and what follows to scratch.line, until the surface ends or the
  /// way comes back.
  void Walk(uint32_t first, SweepScratch& scratch) const;

  const ConnectedMesh* mesh_;
  std::vector<Coord> planes_nm_;
  std::vector<LeveledVertex> vertices_;
  std::vector<uint32_t> layer_starts_;
  std::vector<uint32_t> faces_;  ///< layer after layer
};

}  // namespace slicefarm::slicing
