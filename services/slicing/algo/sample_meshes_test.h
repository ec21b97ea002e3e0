#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/vector.h"
#include "services/slicing/algo/mesh_io/raw_mesh.h"

namespace slicefarm::slicing {

/// Meshes of known shape for tests and benchmarks, in mm, and the files that say them.

/// A box of 8 vertices and 12 triangles. REQUIRES: min < max in each coordinate.
RawMesh BoxMesh(const Vector3& min, const Vector3& max);

/// A box of three equal sides, its least corner at x, y, z.
RawMesh Cube(double x, double y, double z, double size = 10);

/// The tetrahedron of the origin and the ends of the three axes of length `size`.
RawMesh TetrahedronMesh(double size);

struct TorusShape {
  double ring_radius = 30;  ///< of the circle in the middle of the tube, around the z axis
  double tube_radius = 10;
  int around = 64;  ///< segments around the z axis
  int sides = 32;   ///< of the tube
  /// If above 0, heights over the lowest point are rounded to odd multiples of half of this, so
  /// that all vertices lie exactly on the planes that cut layers of this height.
  double snap_to_layer = 0;
};

/// A closed torus of 2 * around * sides triangles that stands on z = 0.
RawMesh TorusMesh(const TorusShape& shape);

/// Both meshes, their vertices not shared.
RawMesh Joined(const RawMesh& a, const RawMesh& b);
RawMesh Moved(RawMesh mesh, const Vector3& by);
/// The same surface with its inside outside.
RawMesh TurnedInsideOut(RawMesh mesh);
/// Mirrored in the plane x = 0; the outside stays outside.
RawMesh Mirrored(RawMesh mesh);
/// The triangles in another order, each starting at another corner; the same for the same seed.
RawMesh Shuffled(RawMesh mesh, uint32_t seed);
RawMesh WithoutTriangle(RawMesh mesh, size_t index);

std::string ToBinaryStl(const RawMesh& mesh);  ///< rounds to float
std::string ToAsciiStl(const RawMesh& mesh);
std::string ToObj(const RawMesh& mesh);

}  // namespace slicefarm::slicing
