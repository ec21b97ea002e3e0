#include "services/slicing/algo/topology/mesh_measure.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::slicing {
namespace {

/// A difference of two products above this value is not zero in exact arithmetic. Factors below
/// 2^32 give products below 2^64, in which a double has errors up to 2^11.
constexpr double kSurelyNotZero = 16'384;

bool IsZeroCross(Coord ax, Coord ay, Coord bx, Coord by) {
  const double guess = static_cast<double>(ax) * static_cast<double>(by) -
                       static_cast<double>(ay) * static_cast<double>(bx);
  if (std::abs(guess) > kSurelyNotZero) return false;
  return static_cast<__int128>(ax) * by == static_cast<__int128>(ay) * bx;
}

}  // namespace

__int128 SixVolumes(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle) {
  const Vertex& a = mesh.vertices[triangle[0]];
  const Vertex& b = mesh.vertices[triangle[1]];
  const Vertex& c = mesh.vertices[triangle[2]];
  const __int128 twice_shadow = static_cast<__int128>(b.x - a.x) * (c.y - a.y) -
                                static_cast<__int128>(b.y - a.y) * (c.x - a.x);
  return twice_shadow * (a.z + b.z + c.z);
}

double VolumeMm3(const IndexedMesh& mesh) {
  __int128 sum = 0;
  for (const auto& triangle : mesh.triangles) sum += SixVolumes(mesh, triangle);
  return static_cast<double>(sum) / 6 / 1e18;
}

bool HasNoArea(const IndexedMesh& mesh, const std::array<uint32_t, 3>& triangle) {
  const Vertex& a = mesh.vertices[triangle[0]];
  const Vertex& b = mesh.vertices[triangle[1]];
  const Vertex& c = mesh.vertices[triangle[2]];
  const Coord bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const Coord cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  return IsZeroCross(bx, by, cx, cy) && IsZeroCross(by, bz, cy, cz) && IsZeroCross(bz, bx, cz, cx);
}

Extent ExtentOf(const IndexedMesh& mesh) {
  Extent extent;
  for (const Vertex& v : mesh.vertices) {
    extent.min = {std::min(extent.min.x, v.x), std::min(extent.min.y, v.y),
                  std::min(extent.min.z, v.z)};
    extent.max = {std::max(extent.max.x, v.x), std::max(extent.max.y, v.y),
                  std::max(extent.max.z, v.z)};
  }
  return extent;
}

void Extent::Add(const Extent& other) {
  min = {std::min(min.x, other.min.x), std::min(min.y, other.min.y), std::min(min.z, other.min.z)};
  max = {std::max(max.x, other.max.x), std::max(max.y, other.max.y), std::max(max.z, other.max.z)};
}

}  // namespace slicefarm::slicing
