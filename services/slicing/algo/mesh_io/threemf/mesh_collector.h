#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "absl/status/status.h"
#include "common/model/scene/mesh.h"
#include "services/slicing/algo/mesh_io/mesh_builder.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"
#include "services/slicing/algo/mesh_io/threemf/paint/painted_area.h"

namespace slicefarm::slicing::threemf {

/// What people paint on the triangles of a mesh besides seams and supports, as flags.
enum Paint : uint8_t {
  kPaintedColours = 1,
  kPaintedFuzzySkin = 2,
};

/// How meshes are read, and how much there was of all of them so far.
struct MeshReading {
  bool keep = true;  ///< else they are only checked and counted
  double coordinate_limit_mm = 0;
  int64_t vertices = 0;
  int64_t triangles = 0;  ///< painted pieces included
  int64_t resources = 0;  ///< objects, their uses as components, and painted areas
};

/// One mesh on its way from `vertex` and `triangle` elements, and what is painted on it. Errors
/// (without a place): MESH_MALFORMED for missing numbers, indices of no vertex and paint that is
/// none, MESH_NOT_FINITE, OUT_OF_RANGE, MESH_TOO_LARGE.
class MeshCollector {
 public:
  /// Keeps `reading`, and counts there.
  MeshCollector(double unit_mm, MeshReading& reading)
      : unit_mm_(unit_mm),
        reading_(reading),
        seams_(reading.coordinate_limit_mm),
        supports_(reading.coordinate_limit_mm) {}

  absl::Status Vertex(XmlAttributes attributes);
  absl::Status Triangle(XmlAttributes attributes);

  int64_t triangles() const { return triangles_; }
  uint8_t paint() const { return paint_; }  ///< Paint flags
  /// Whether triangles name a material or colour.
  bool coloured() const { return coloured_; }

  /// The areas' meshes leave this.
  MeshPaint TakeMarks();
  /// Welded; without anything if meshes are not kept.
  RawMesh Take() &&;

 private:
  /// Marks of one use on their way.
  struct Marks {
    explicit Marks(double limit_mm) : enforcers(0, limit_mm), blockers(0, limit_mm) {}

    MarkPaint Take();

    MeshBuilder enforcers, blockers;
    MarkPaint paint;  ///< its meshes are those of the builders
  };

  absl::Status CountTriangle();
  void Note(const XmlAttribute& attribute);
  absl::Status AddMarks(std::string_view code, const std::array<uint32_t, 3>& corners,
                        Marks& marks);

  double unit_mm_;
  MeshReading& reading_;
  RawMesh mesh_;
  Marks seams_, supports_;
  int64_t vertices_ = 0;
  int64_t triangles_ = 0;
  uint8_t paint_ = 0;
  bool coloured_ = false;
};

}  // namespace slicefarm::slicing::threemf
