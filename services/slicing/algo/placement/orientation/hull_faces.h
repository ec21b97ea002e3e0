#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// Convex hull of points in space, in mm.
struct SpaceHull {
  struct Face {
    Eigen::Vector3d normal;  ///< unit normal, outwards
    double area_mm2 = 0;
  };
  std::vector<Eigen::Vector3d> corners;
  /// triangles of the hull; a flat side of several triangles is not merged into one face
  std::vector<Face> faces;
};

/// Returns the hull of all vertices. It is exact for up to 20,000 vertices.
///
/// For more vertices, a hull of selected vertices is computed first. Vertices less than 0.02 mm
/// outside of this hull are left out. If too many vertices would remain, this distance is larger.
/// So the faces of the result may be off by this distance, and slightly tilted.
///
/// Shapes: for vertices in one plane, the hull has faces on both sides; for vertices on a line or
/// in a point, it has no faces. Cost: O(n), plus a hull of at most 20,000 points: 0.2 s for a
/// million triangles. Source: CGAL's quickhull (C. B. Barber et al., "The Quickhull Algorithm for
/// Convex Hulls", ACM TOMS 22 (1996)), with exact predicates. Only the .cc includes CGAL.
SpaceHull HullOf(std::span<const Vertex> vertices);

}  // namespace slicefarm::slicing
