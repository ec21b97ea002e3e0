#include "services/texture/algo/surface_mapping.h"

#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/texture/algo/map/flatten.h"
#include "services/texture/algo/surface/cut_open.h"
#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/seam.h"

namespace slicefarm::texture {
namespace {

/// Largest number of points of a map, so that it fits in one message
/// (limits::kMaxStageMessageBytes): 43 bytes per point, 9 per triangle.
constexpr int64_t kMostMapPoints = 1'200'000;
static_assert(43 * kMostMapPoints + 9 * limits::kMaxSurfaceTriangles <
              limits::kMaxStageMessageBytes);

}  // namespace

absl::StatusOr<MappedSurface> MapSurface(const SurfaceInput& surface, const CancelToken& cancel) {
  const SurfaceMesh& mesh = surface.mesh;
  if (std::ssize(mesh.triangles) > limits::kMaxSurfaceTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles of a surface", limits::kMaxSurfaceTriangles,
                      std::ssize(mesh.triangles));
  const auto topology = TopologyOf(mesh);
  if (!topology.ok()) return topology.status();
  const auto seam = surface.seam ? SeamOf(mesh, *topology) : std::vector<SeamEdge>();
  OpenedSurface opened = CutOpen(mesh, seam);
  if (std::ssize(opened.mesh.points_mm) > kMostMapPoints)
    return LimitError(Reason::kMeshTooLarge, "points of a surface that is laid flat",
                      kMostMapPoints, std::ssize(opened.mesh.points_mm));
  auto map = Flatten(opened.mesh, {}, cancel);
  if (!map.ok()) return map.status();
  return MappedSurface{std::move(opened.mesh), std::move(opened.vertex_of),
                       std::move(map->points_mm)};
}

}  // namespace slicefarm::texture
