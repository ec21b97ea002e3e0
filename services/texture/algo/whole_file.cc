#include "services/texture/algo/whole_file.h"

#include <vector>

#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/output/displaced_mesh.h"
#include "services/texture/algo/output/surface_picture.h"
#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {
namespace {

constexpr double kLightestDistortion = 3;

/// Returns every worked line, in the order of work. Lines of the first layer are dark, later layers
/// lighter.
std::vector<PictureLine> WorkedLines(const std::vector<LayerPath>& paths) {
  std::vector<PictureLine> lines;
  for (size_t k = 0; k < paths.size(); ++k) {
    const std::vector<ToolPoint>& points = paths[k].points;
    const double shade = (static_cast<double>(k) + 1) / static_cast<double>(paths.size());
    for (size_t i = 1; i < points.size(); ++i)
      if (points[i].on)
        lines.push_back({points[i - 1].place_mm, points[i].place_mm, points[i].normal, shade});
  }
  return lines;
}

absl::StatusOr<std::string> LinePicture(const EngravePlan& plan, const CancelToken& cancel) {
  const auto paths = LayerPaths(plan, 0, plan.layer_count(), cancel);
  if (!paths.ok()) return paths.status();
  return DrawSurface(plan.map.mesh(), WorkedLines(*paths), {});
}

absl::StatusOr<std::string> MapPicture(const SurfaceMap& map) {
  const SurfaceMesh& mesh = map.mesh();
  std::vector<double> energies;
  for (const auto& [a, b, c] : mesh.triangles) {
    const RestTriangle rest = RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
    energies.push_back(
        SymmetricDirichlet(JacobianOf(rest, map.map_mm()[a], map.map_mm()[b], map.map_mm()[c])) /
        4);
  }
  return DrawMap(mesh, map.map_mm(), energies, kLightestDistortion,
                 SurfacePictureOptions().size_px);
}

}  // namespace

absl::StatusOr<std::string> WholeFile(const EngraveJob& job, const CancelToken& cancel) {
  if (job.format == EngraveFormat::kPng) return LinePicture(job.plan, cancel);
  if (job.format == EngraveFormat::kMapPng) return MapPicture(job.plan.map);
  const auto mesh = DisplacedMesh(job.plan, {job.displaced_edge_mm});
  if (!mesh.ok()) return mesh.status();
  return job.format == EngraveFormat::kObj ? ObjText(*mesh) : StlBytes(*mesh);
}

}  // namespace slicefarm::texture
