#include "services/slicing/algo/section/surface_slabs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "common/geometry/boolean/union_of_many.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::slicing {
namespace {

/// Returns the point of an edge at a height; the result does not depend on the order of the
/// vertices.
Vertex At(Vertex a, Vertex b, Coord z_nm) {
  if (a.z > b.z) std::swap(a, b);
  const double share = static_cast<double>(z_nm - a.z) / static_cast<double>(b.z - a.z);
  return {a.x + std::llround(share * static_cast<double>(b.x - a.x)),
          a.y + std::llround(share * static_cast<double>(b.y - a.y)), z_nm};
}

/// Returns the part of a polygon in space on one side of a height: above it if `sign` is 1, below
/// it if -1.
std::vector<Vertex> Beyond(const std::vector<Vertex>& polygon, Coord z_nm, int sign) {
  std::vector<Vertex> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vertex& a = polygon[i];
    const Vertex& b = polygon[(i + 1) % polygon.size()];
    const bool a_in = sign * (a.z - z_nm) >= 0, b_in = sign * (b.z - z_nm) >= 0;
    if (a_in) kept.push_back(a);
    if (a_in != b_in) kept.push_back(At(a, b, z_nm));
  }
  return kept;
}

/// Returns the region without details that its growth by `reach_nm` hides: holes that close, and
/// steps of less than a twentieth of `reach_nm`. The boundary of painted areas consists of many
/// small steps, because they are painted in tiny triangles.
MultiPolygon WithoutDetails(MultiPolygon region, Coord reach_nm) {
  const auto simplify = [&](Polygon& ring) {
    Polygon simple = SimplifyRing(ring, reach_nm / 20);
    if (!simple.empty()) ring = std::move(simple);  // a strip narrower than that has a reach too
  };
  for (PolygonWithHoles& island : region) {
    std::erase_if(island.holes, [&](const Polygon& hole) {
      const Box box = Bounds(hole);
      return std::min(box.max.x - box.min.x, box.max.y - box.min.y) < 2 * reach_nm;
    });
    simplify(island.outer);
    for (Polygon& hole : island.holes) simplify(hole);
  }
  return region;
}

}  // namespace

SurfaceSlabs::SurfaceSlabs(const IndexedMesh& mesh, std::vector<Slab> slabs, Faces faces)
    : mesh_(&mesh), slabs_(std::move(slabs)), faces_(slabs_.size()) {
  for (uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle& t = mesh.triangles[face];
    const auto [low, high] =
        std::minmax({mesh.vertices[t[0]].z, mesh.vertices[t[1]].z, mesh.vertices[t[2]].z});
    if (faces == Faces::kLevelAlone && low != high) continue;
    auto slab = std::partition_point(slabs_.begin(), slabs_.end(),
                                     [low = low](const Slab& s) { return s.high_nm < low; });
    for (; slab != slabs_.end() && slab->low_nm <= high; ++slab)
      faces_[static_cast<size_t>(slab - slabs_.begin())].push_back(face);
  }
}

Polygon SurfaceSlabs::PieceOf(const Triangle& face, const Slab& slab) const {
  std::vector<Vertex> piece;
  for (const uint32_t corner : face) piece.push_back(mesh_->vertices[corner]);
  piece = Beyond(Beyond(piece, slab.low_nm, 1), slab.high_nm, -1);
  Polygon shadow;
  for (const Vertex& v : piece)
    if (shadow.empty() || shadow.back() != Point{v.x, v.y}) shadow.push_back({v.x, v.y});
  if (shadow.size() < 3) return {};
  if (SignedArea(shadow) < 0) std::reverse(shadow.begin(), shadow.end());
  return shadow;
}

MultiPolygon SurfaceSlabs::Shadow(size_t slab, Coord reach_nm, const CancelToken& cancel) const {
  std::vector<Polygon> pieces;
  for (const uint32_t face : faces_[slab])
    if (Polygon piece = PieceOf(mesh_->triangles[face], slabs_[slab]); !piece.empty())
      pieces.push_back(std::move(piece));
  if (pieces.empty()) return {};
  MultiPolygon whole = UnionOfMany(std::move(pieces), cancel);
  if (cancel.Cancelled()) return {};
  return FastOffset(WithoutDetails(std::move(whole), reach_nm), reach_nm);
}

}  // namespace slicefarm::slicing
