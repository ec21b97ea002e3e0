#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

// Meshes of known shape for tests and benchmarks, in mm, and their files.

/// Returns a box of 8 vertices and 12 triangles. REQUIRES: min < max in each coordinate.
RawMesh BoxMesh(const Vector3& min, const Vector3& max);

/// Returns a cube with its smallest corner at x, y, z.
RawMesh Cube(double x, double y, double z, double size = 10);

/// Returns the tetrahedron of the origin and the three points at distance `size` on the axes.
RawMesh TetrahedronMesh(double size);

struct TorusShape {
  double ring_radius = 30;  ///< radius of the circle in the middle of the tube, around the z axis
  double tube_radius = 10;
  int around = 64;  ///< segments around the z axis
  int sides = 32;   ///< segments around the tube
  /// Layer height to snap to; 0: none. Heights above the lowest point are rounded to odd multiples
  /// of half of it, so all vertices are exactly on the planes that cut layers of this height.
  double snap_to_layer = 0;
};

/// Returns a closed torus of 2 * around * sides triangles that stands on z = 0.
RawMesh TorusMesh(const TorusShape& shape);

/// Returns both meshes as one, without sharing vertices.
RawMesh Joined(const RawMesh& a, const RawMesh& b);
RawMesh Moved(RawMesh mesh, const Vector3& by);
/// Returns the same surface with inside and outside exchanged.
RawMesh TurnedInsideOut(RawMesh mesh);
/// Returns the mesh mirrored at the plane x = 0; the outside stays outside.
RawMesh Mirrored(RawMesh mesh);
/// Returns the triangles in another order, each starting at another corner. One seed always gives
/// one result.
RawMesh Shuffled(RawMesh mesh, uint32_t seed);
RawMesh WithoutTriangle(RawMesh mesh, size_t index);

std::string ToBinaryStl(const RawMesh& mesh);  ///< rounds to float
std::string ToAsciiStl(const RawMesh& mesh);
std::string ToObj(const RawMesh& mesh);

}  // namespace slicefarm::slicing
