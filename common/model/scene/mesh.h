#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

/// File format of a mesh.
enum class MeshFormat { kUnknown, kStl, kObj, kPly, k3mf };

/// Unchanged content of a mesh file.
struct MeshFile {
  std::string name;                          ///< name given by the user; never used as a path
  MeshFormat format = MeshFormat::kUnknown;  ///< format; kUnknown: detected from the content
  std::string bytes;
};

/// Point in space, in nanometres.
struct Vertex {
  Coord x = 0;
  Coord y = 0;
  Coord z = 0;

  friend auto operator<=>(const Vertex&, const Vertex&) = default;
};

/// Triangle mesh with shared vertices, in nanometres.
struct IndexedMesh {
  std::vector<Vertex> vertices;
  /// Vertex indices, counter-clockwise as seen from outside.
  std::vector<std::array<uint32_t, 3>> triangles;

  friend bool operator==(const IndexedMesh&, const IndexedMesh&) = default;
};

/// Properties and defects of a mesh, part of every job's report. Every repair of the mesh is
/// counted here.
struct MeshReport {
  std::string name;
  int64_t triangles = 0;
  int64_t vertices = 0;  ///< number of vertices after equal positions of the file are merged
  /// number of separate bodies: sets of faces that share no edge with each other
  int64_t bodies = 0;
  int64_t open_edges = 0;  ///< number of edges with only one face, as read from the file
  /// number of edges with more than two faces, as read from the file
  int64_t non_manifold_edges = 0;
  /// Number of faces with the opposite orientation of most faces around them. Slicing flips these
  /// faces.
  int64_t flipped_faces = 0;
  /// Number of faces without area, including faces that lose their area by rounding to nanometres.
  int64_t degenerate_faces = 0;
  /// number of faces that have the same corners as another face; these faces are left out
  int64_t repeated_faces = 0;
  double volume_mm3 = 0;                     ///< signed volume of one copy, as placed
  std::array<double, 3> min_mm = {0, 0, 0};  ///< bounding box of the first copy, as placed
  std::array<double, 3> max_mm = {0, 0, 0};
  // Results of slicing:
  /// Number of loops that had a gap within the limit of the settings
  /// (JobSlicingOptions::max_gap_nm) and were closed.
  int64_t open_loops_closed = 0;
  int64_t open_loops_dropped = 0;  ///< number of loops that remained open and are not printed
  double largest_gap_closed_mm = 0;
  double dropped_length_mm = 0;    ///< length of the outlines that were not printed
  int64_t copies_off_bed = 0;      ///< number of copies beside the bed, which are left out
  int64_t overlapping_copies = 0;  ///< number of copies that overlap another copy
  double cracks_closed_mm = 0;  ///< largest width of closed cracks; 0: cracks were not searched for

  bool Closed() const { return open_edges == 0 && non_manifold_edges == 0; }
  friend bool operator==(const MeshReport&, const MeshReport&) = default;
};

/// File format of a picture.
enum class PictureFormat : uint8_t {
  kPng,
  kQoi,
  kJpg,
  kBtt,     ///< text for touch screens of BigTreeTech
  kColPic,  ///< text for screens of Elegoo and Qidi
};

/// View and use of a picture of the plate.
enum class PictureRole : uint8_t {
  kProgram,  ///< isometric view of the parts, at the head of the G-code
  // Pictures of a .gcode.3mf archive:
  kPlate,  ///< isometric view of the parts
  kUnlit,  ///< the same view without shades
  kTop,    ///< view of the bed from above
  kPick,   ///< the same view; the colour of a pixel is the id of the copy that covers it (PickId)
};

/// Size, format and role of a requested picture of the plate.
struct ThumbnailSize {
  int32_t width_px = 0;
  int32_t height_px = 0;
  PictureFormat format = PictureFormat::kPng;
  PictureRole role = PictureRole::kProgram;

  friend bool operator==(const ThumbnailSize&, const ThumbnailSize&) = default;
};

/// Returns the id of a copy in pictures of the role kPick, and in the archive that has them. Red is
/// the lowest byte of the id, then green and blue. Pixels without a copy are transparent.
inline int32_t PickId(int32_t copy) { return copy + 1; }

/// Picture of the plate.
struct Thumbnail {
  int32_t width_px = 0;
  int32_t height_px = 0;
  std::string data;  ///< file content in the format `format`
  PictureFormat format = PictureFormat::kPng;
  PictureRole role = PictureRole::kProgram;

  friend bool operator==(const Thumbnail&, const Thumbnail&) = default;
};

}  // namespace slicefarm
