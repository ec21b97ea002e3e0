#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"
#include "services/slicing/algo/mesh_io/weld.h"

namespace slicefarm::slicing {

/// Reason why a number is not a valid coordinate.
enum class CoordinateFault { kNone, kNotFinite, kBeyondLimit };

/// Builder of a RawMesh from triangle corners, used by both STL readers. It checks, welds and
/// collects the corners.
class MeshBuilder {
 public:
  MeshBuilder(size_t expected_triangles, double coordinate_limit)
      : welder_(expected_triangles / 2 + 1), limit_(coordinate_limit) {
    mesh_.triangles.reserve(expected_triangles);
  }

  /// Returns the reason why a coordinate of `p` is not valid, or kNone.
  CoordinateFault Check(const Vector3& p) const {
    if (std::abs(p.x()) <= limit_ && std::abs(p.y()) <= limit_ && std::abs(p.z()) <= limit_)
      return CoordinateFault::kNone;
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())
               ? CoordinateFault::kBeyondLimit
               : CoordinateFault::kNotFinite;
  }

  /// Adds a triangle. REQUIRES: all three corners pass Check.
  void Add(const std::array<Vector3, 3>& corners) {
    mesh_.triangles.push_back({Weld(corners[0]), Weld(corners[1]), Weld(corners[2])});
  }

  /// Returns the number of triangles added.
  size_t triangles() const { return mesh_.triangles.size(); }

  /// Returns the mesh. The builder must not be used afterwards.
  RawMesh Take() && {
    mesh_.positions = std::move(welder_).TakePoints();
    return std::move(mesh_);
  }

 private:
  /// Returns the index of the welded point. Adding zero gives -0 and +0 the same bits.
  uint32_t Weld(const Vector3& p) { return welder_.Add({p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}); }

  Welder<Vector3> welder_;
  RawMesh mesh_;
  double limit_;
};

}  // namespace slicefarm::slicing
