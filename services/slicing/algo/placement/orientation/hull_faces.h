#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::slicing {

/// The convex hull of points in space, mm.
struct SpaceHull {
  struct Face {
    Eigen::Vector3d normal;  ///< unit, outwards
    double area_mm2 = 0;
  };
  std::vector<Eigen::Vector3d> corners;
  std::vector<Face> faces;  ///< triangles; those of one plane are not joined
};

/// The hull of all vertices, exact up to 20,000 of them. Of more, points that reach out of the hull
/// of a selection by less than 0.02 mm are left out, or by more where too many would remain: so
/// faces may be tilted by that much.
///
/// Shapes: a flat set has the faces of both sides, a line or a point has no faces.
/// Cost:   O(n), and a hull of at most 20,000 points: 0.2 s for a million triangles.
/// Source: CGAL's quickhull (C. B. Barber et al., "The Quickhull Algorithm for Convex Hulls", ACM
///         TOMS 22 (1996)), with exact predicates. Only the .cc includes CGAL.
SpaceHull HullOf(std::span<const Vertex> vertices);

}  // namespace slicefarm::slicing
