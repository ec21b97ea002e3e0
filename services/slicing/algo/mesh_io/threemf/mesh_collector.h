#pragma once

#include <cstdint>
#include <string_view>

#include "absl/status/status.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {

/// What people paint on the triangles of a mesh, as flags.
enum Paint : uint8_t {
  kPaintedSupports = 1,
  kPaintedSeams = 2,
  kPaintedColours = 4,
  kPaintedFuzzySkin = 8,
};

/// How meshes are read, and how much there was of all of them so far.
struct MeshReading {
  bool keep = true;  ///< else they are only checked and counted
  double coordinate_limit_mm = 0;
  int64_t vertices = 0;
  int64_t triangles = 0;
  int64_t resources = 0;  ///< objects, and their uses as components
};

/// One mesh on its way from `vertex` and `triangle` elements. Errors (without a place):
/// MESH_MALFORMED for missing numbers and indices of no vertex, MESH_NOT_FINITE, OUT_OF_RANGE,
/// MESH_TOO_LARGE.
class MeshCollector {
 public:
  /// Keeps `reading`, and counts there.
  MeshCollector(double unit_mm, MeshReading& reading) : unit_mm_(unit_mm), reading_(reading) {}

  absl::Status Vertex(XmlAttributes attributes);
  absl::Status Triangle(XmlAttributes attributes);

  int64_t triangles() const { return triangles_; }
  uint8_t paint() const { return paint_; }
  /// Whether triangles name a material or colour.
  bool coloured() const { return coloured_; }

  /// Welded; without anything if meshes are not kept.
  RawMesh Take() &&;

 private:
  void Note(const XmlAttribute& attribute);

  double unit_mm_;
  MeshReading& reading_;
  RawMesh mesh_;
  int64_t vertices_ = 0;
  int64_t triangles_ = 0;
  uint8_t paint_ = 0;
  bool coloured_ = false;
};

}  // namespace slicefarm::slicing::threemf
