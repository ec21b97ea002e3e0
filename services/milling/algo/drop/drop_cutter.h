#pragma once

#include <Eigen/Core>
#include <optional>

#include "common/model/options/cutter.h"
#include "services/milling/algo/mesh/triangle_mesh.h"
#include "services/milling/algo/push/local_push.h"

namespace slicefarm::milling {

/// Lowest position of a cutter over a mesh at which the cutter does not gouge, and its contact.
struct Drop {
  double z_mm = 0;  ///< height of the cutter's tip
  Eigen::Vector3d contact_mm{0, 0, 0};
};

/// Lowers a cutter onto a mesh. It is consistent with the push cutter (push/fiber_push.h): with the
/// tip at height z, a position is gouged if and only if the lowered cutter stops above z.
///
/// Over a triangle, consider the triangle's height minus the height of the cutter's profile, at
/// each point below the cutter. This function is concave. Its maximum is where the triangle's slope
/// touches the profile, or at one of a few points on a side. These points are known in closed form,
/// or by a bracketed root for a bull nose. The mesh and the cutter must outlive this object.
class DropCutter {
 public:
  DropCutter(const TriangleMesh& mesh, const Cutter& cutter)
      : mesh_(mesh), cutter_(cutter), triangles_(mesh) {}

  /// Returns the lowest position at `place_mm`. Returns nullopt if no part of the mesh is under the
  /// cutter; contact with the side of its shaft does not count. Cost: 0.3 us for each triangle that
  /// is under the cutter and not below the result.
  std::optional<Drop> At(const Eigen::Vector2d& place_mm) const;

 private:
  const TriangleMesh& mesh_;
  const Cutter& cutter_;
  TriangleGrid triangles_;
};

}  // namespace slicefarm::milling
