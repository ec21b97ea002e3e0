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

/// Flags for kinds of paint on triangles; paint of seams and supports has no flag.
enum Paint : uint8_t {
  kPaintedColours = 1,
  kPaintedFuzzySkin = 2,
};

/// Options for reading meshes, and totals over all meshes read so far.
struct MeshReading {
  bool keep = true;  ///< true: keeps the meshes; false: only checks and counts them
  double coordinate_limit_mm = 0;
  int64_t vertices = 0;
  int64_t triangles = 0;  ///< number of triangles, painted pieces included
  int64_t resources = 0;  ///< number of objects, of components, and of painted areas
};

/// Collector of one mesh and its paint from `vertex` and `triangle` elements.
///
/// Errors (without a location): MESH_MALFORMED for missing numbers, invalid vertex indices and
/// invalid paint; MESH_NOT_FINITE; OUT_OF_RANGE for a coordinate above the limit of `reading`.
/// MESH_TOO_LARGE if the totals of `reading` exceed kMaxVertices or limits::kMaxTriangles.
class MeshCollector {
 public:
  /// Keeps a reference to `reading` and adds to its totals.
  MeshCollector(double unit_mm, MeshReading& reading)
      : unit_mm_(unit_mm),
        reading_(reading),
        seams_(reading.coordinate_limit_mm),
        supports_(reading.coordinate_limit_mm) {}

  /// Adds a vertex from the attributes of its element.
  absl::Status Vertex(XmlAttributes attributes);
  /// Adds a triangle and its paint from the attributes of its element.
  absl::Status Triangle(XmlAttributes attributes);

  int64_t triangles() const { return triangles_; }
  uint8_t paint() const { return paint_; }  ///< flags of Paint
  /// Returns true if triangles refer to a material or colour.
  bool coloured() const { return coloured_; }

  /// Returns the painted seams and supports. Their meshes are moved out of the collector.
  MeshPaint TakeMarks();
  /// Returns the welded mesh; an empty one if meshes are not kept.
  RawMesh Take() &&;

 private:
  /// Marks for seams, or marks for supports, while the mesh is read.
  struct Marks {
    explicit Marks(double limit_mm) : enforcers(0, limit_mm), blockers(0, limit_mm) {}

    MarkPaint Take();

    MeshBuilder enforcers, blockers;
    MarkPaint paint;  ///< painted areas; their meshes are still in the builders
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
