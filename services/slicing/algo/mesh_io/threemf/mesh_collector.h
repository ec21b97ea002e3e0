#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "absl/status/status.h"
#include "services/slicing/algo/mesh_io/mesh_builder.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/paint/painted_area.h"

namespace slicefarm::slicing::threemf {

/// What people paint on the triangles of a mesh besides seams, as flags.
enum Paint : uint8_t {
  kPaintedSupports = 1,
  kPaintedColours = 2,
  kPaintedFuzzySkin = 4,
};

/// How meshes are read, and how much there was of all of them so far.
struct MeshReading {
  bool keep = true;  ///< else they are only checked and counted
  double coordinate_limit_mm = 0;
  int64_t vertices = 0;
  int64_t triangles = 0;  ///< pieces that are painted as seams included
  int64_t resources = 0;  ///< objects, their uses as components, and painted areas
};

/// One mesh on its way from `vertex` and `triangle` elements, and the seams painted on it. Errors
/// (without a place): MESH_MALFORMED for missing numbers, indices of no vertex and paint that is
/// none, MESH_NOT_FINITE, OUT_OF_RANGE, MESH_TOO_LARGE.
class MeshCollector {
 public:
  /// Keeps `reading`, and counts there.
  MeshCollector(double unit_mm, MeshReading& reading)
      : unit_mm_(unit_mm),
        reading_(reading),
        enforcers_(0, reading.coordinate_limit_mm),
        blockers_(0, reading.coordinate_limit_mm) {}

  absl::Status Vertex(XmlAttributes attributes);
  absl::Status Triangle(XmlAttributes attributes);

  int64_t triangles() const { return triangles_; }
  uint8_t paint() const { return paint_; }  ///< Paint flags
  /// Whether triangles name a material or colour.
  bool coloured() const { return coloured_; }

  /// The areas' meshes leave this.
  SeamPaint TakeSeams();
  /// Welded; without anything if meshes are not kept.
  RawMesh Take() &&;

 private:
  absl::Status CountTriangle();
  void Note(const XmlAttribute& attribute);
  absl::Status PaintSeam(std::string_view code, const std::array<uint32_t, 3>& corners);

  double unit_mm_;
  MeshReading& reading_;
  RawMesh mesh_;
  MeshBuilder enforcers_, blockers_;
  SeamPaint seams_;  ///< its meshes are those of the builders
  int64_t vertices_ = 0;
  int64_t triangles_ = 0;
  uint8_t paint_ = 0;
  bool coloured_ = false;
};

}  // namespace slicefarm::slicing::threemf
