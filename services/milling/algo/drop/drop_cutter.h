#pragma once

#include <Eigen/Core>
#include <optional>

#include "common/model/options/cutter.h"
#include "services/milling/algo/mesh/triangle_mesh.h"
#include "services/milling/algo/push/local_push.h"

namespace slicefarm::milling {

/// Where a cutter that is let down comes to rest.
struct Drop {
  double z_mm = 0;  ///< of its tip: the least at which it does not gouge
  Eigen::Vector3d contact_mm{0, 0, 0};
};

/// Lets a cutter down on a mesh: the dual of the push cutter. A place is gouged with the tip at z
/// if and only if the cutter let down there rests higher.
///
/// Over a triangle, z less the height of the cutter's outline over the distance from its axis is
/// concave: largest where the slope of the triangle touches the outline, or on a side, at one of
/// few places in closed form (on a bull nose, by a bracketed root). Mesh and cutter must outlive
/// it.
class DropCutter {
 public:
  DropCutter(const TriangleMesh& mesh, const Cutter& cutter)
      : mesh_(mesh), cutter_(cutter), triangles_(mesh) {}

  /// Empty: no part of the mesh is under the cutter; touching with the side of its shaft is not.
  /// Cost: 0.3 us for each triangle under it that is not below the result.
  std::optional<Drop> At(const Eigen::Vector2d& place_mm) const;

 private:
  const TriangleMesh& mesh_;
  const Cutter& cutter_;
  TriangleGrid triangles_;
};

}  // namespace slicefarm::milling
