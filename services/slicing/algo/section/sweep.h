#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/slicing/algo/topology/topology.h"

namespace slicefarm::slicing {

/// Section of a mesh in one plane, with the material on the left of the lines.
struct Section {
  std::vector<Polygon> loops;  ///< closed lines
  /// open lines, which begin and end where the surface has a boundary
  std::vector<Polyline> chains;
};

/// Memory of one thread, which Sweep::Cut uses again for each layer.
struct SweepScratch {
  std::vector<uint32_t>
      /// index of each face's segment; only the entries of the current layer's faces are valid
      segment_of_face;
  std::vector<Point> ends;      ///< end point of each segment
  std::vector<uint32_t> exits;  ///< half-edge on the other side of the rising edge, per segment
  std::vector<uint8_t> marks;   ///< state of each segment
  std::vector<Point> line;
};

/// Cuts a mesh by many horizontal planes.
///
/// One rule defines all cases: a vertex is above a plane if and only if z_vertex >= z_plane. A face
/// is in a layer if it has a vertex above the plane and one not above it, so zmin < z <= zmax. Then
/// exactly two of its edges cross the plane, and each neighbour over these edges is in the layer
/// too. So horizontal faces are in no layer, and vertices on the plane need no special case.
///
/// Each vertex stores the number of planes that it is above. Faces are sorted into layers by
/// counting. In a layer, a face gives one segment. The segment ends where the rising edge crosses
/// the plane, and the next segment belongs to the face on the other side of this edge. No search by
/// position is needed. A crossing is interpolated from the lower to the upper end of its edge in
/// integers, rounded to the nearest nm. So it depends on these two points and the plane alone.
///
/// Units: nm. The planes ascend. The mesh is within 32 bits and must outlive the sweep. Cost:
/// O(faces + segments), 4 bytes per segment.
class Sweep {
 public:
  /// Sorts the faces into layers. `other_points`: total number of segments (a segment counts as one
  /// point) of the parts of the job that were prepared earlier. Errors: MESH_TOO_LARGE if one layer
  /// has more than limits::kMaxPointsPerLayer segments, or if all layers and `other_points`
  /// together exceed limits::kMaxPointsPerJob.
  static absl::StatusOr<Sweep> Prepare(const ConnectedMesh& mesh, std::span<const Coord> planes_nm,
                                       int64_t other_points = 0);

  /// Returns the section in plane `layer`, without repeated points and without loops of fewer than
  /// three points. The order of the loops and their start points follow the order of the triangles.
  /// Safe to call from several threads, each with its own scratch.
  Section Cut(size_t layer, SweepScratch& scratch) const;

  /// Returns the number of segments of all layers.
  int64_t segments() const { return static_cast<int64_t>(faces_.size()); }
  /// Returns the number of segments of a layer.
  int64_t segments(size_t layer) const {
    return static_cast<int64_t>(layer_starts_[layer + 1] - layer_starts_[layer]);
  }

 private:
  /// Vertex, and its level: the number of planes at or below the vertex. The vertex is above plane
  /// k if and only if k < level.
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
  /// Computes one segment per face, in the order of `faces`.
  void CutFaces(std::span<const uint32_t> faces, size_t layer, SweepScratch& scratch) const;
  /// Returns three bits: bit i is set if corner i is in or above the plane of the layer.
  unsigned Above(const Triangle& t, size_t layer) const {
    return (vertices_[t[0]].level > layer) | (vertices_[t[1]].level > layer) << 1 |
           (vertices_[t[2]].level > layer) << 2;
  }
  Polyline Chain(uint32_t first, uint32_t face, size_t layer, SweepScratch& scratch) const;
  Polygon Loop(uint32_t first, SweepScratch& scratch) const;
  /// Appends the ends of `first` and of the following segments to scratch.line, until the surface
  /// ends or the line closes.
  void Walk(uint32_t first, SweepScratch& scratch) const;

  const ConnectedMesh* mesh_;
  std::vector<Coord> planes_nm_;
  std::vector<LeveledVertex> vertices_;
  std::vector<uint32_t> layer_starts_;
  std::vector<uint32_t> faces_;  ///< faces of all layers, layer after layer
};

}  // namespace slicefarm::slicing
