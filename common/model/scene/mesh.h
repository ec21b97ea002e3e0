#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

enum class MeshFormat { kUnknown, kStl, kObj, kPly, k3mf };

/// The bytes of a mesh file as they came.
struct MeshFile {
  std::string name;                          ///< what the user calls it; never used as a path
  MeshFormat format = MeshFormat::kUnknown;  ///< kUnknown: told from the content
  std::string bytes;
};

struct Vertex {
  Coord x = 0;
  Coord y = 0;
  Coord z = 0;

  friend auto operator<=>(const Vertex&, const Vertex&) = default;
};

/// Triangles over shared vertices, in nanometres.
struct IndexedMesh {
  std::vector<Vertex> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside

  friend bool operator==(const IndexedMesh&, const IndexedMesh&) = default;
};

/// What the mesh is like; part of every job's report. Nothing in it is repaired silently.
struct MeshReport {
  std::string name;
  int64_t triangles = 0;
  int64_t vertices = 0;            ///< after welding by exact position, as in the file
  int64_t bodies = 0;              ///< parts that share no edge
  int64_t open_edges = 0;          ///< edges with one face, in the file
  int64_t non_manifold_edges = 0;  ///< edges with more than two faces, in the file
  int64_t flipped_faces = 0;     ///< faces that run against the majority around them; sliced turned
  int64_t degenerate_faces = 0;  ///< no area, or none left in nanometres
  int64_t repeated_faces = 0;    ///< the same as another one, corner by corner; left out
  double volume_mm3 = 0;         ///< signed; as placed; one copy
  std::array<double, 3> min_mm = {0, 0, 0};  ///< as placed; first copy
  std::array<double, 3> max_mm = {0, 0, 0};
  // Of the slicing:
  int64_t open_loops_closed = 0;   ///< loops closed over a gap, as far as the settings allow
  int64_t open_loops_dropped = 0;  ///< loops that stayed open, and are not printed
  double largest_gap_closed_mm = 0;
  double dropped_length_mm = 0;    ///< length of the outlines that were not printed
  int64_t copies_off_bed = 0;      ///< copies that stand beside the bed, and are left out
  int64_t overlapping_copies = 0;  ///< copies that share room with another one
  double cracks_closed_mm = 0;     ///< cracks up to this width were closed; 0: none were looked for

  bool Closed() const { return open_edges == 0 && non_manifold_edges == 0; }
  friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

enum class PictureFormat : uint8_t { kPng, kQoi, kJpg };

/// How a picture of the part is asked for.
struct ThumbnailSize {
  int32_t width_px = 0;
  int32_t height_px = 0;
  PictureFormat format = PictureFormat::kPng;

  friend bool operator==(const ThumbnailSize&, const ThumbnailSize&) = default;
};

/// A picture of the part.
struct Thumbnail {
  int32_t width_px = 0;
  int32_t height_px = 0;
  std::string data;  ///< in its format
  PictureFormat format = PictureFormat::kPng;

  friend bool operator==(const Thumbnail&, const Thumbnail&) = default;
};

}  // namespace slicefarm
