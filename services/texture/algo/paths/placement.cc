#include "services/texture/algo/paths/placement.h"

#include <numbers>

#include "common/base/portable_math.h"
#include "common/model/scene/placement.h"
#include "services/texture/algo/map/distortion.h"

namespace slicefarm::texture {
namespace {

/// Converts a direction in space, at a triangle of the surface, to a direction in the map. Returns
/// nothing if it is perpendicular to the triangle.
std::optional<Eigen::Vector2d> IntoMap(const SurfaceMap& map, int32_t triangle,
                                       const Eigen::Vector3d& direction) {
  const auto& [a, b, c] = map.mesh().triangles[triangle];
  const auto& points = map.mesh().points_mm;
  // The frame is the triangle's one in RestOf: x along its first edge.
  const Eigen::Vector3d x = (points[b] - points[a]).normalized();
  const Eigen::Vector3d y = map.FaceNormal(triangle).cross(x);
  const Eigen::Vector2d flat(x.dot(direction), y.dot(direction));
  if (flat.norm() < 1e-6 * direction.norm()) return std::nullopt;
  const Eigen::Matrix2d jacobian = JacobianOf(RestOf(points[a], points[b], points[c]),
                                              map.map_mm()[a], map.map_mm()[b], map.map_mm()[c]);
  return (jacobian * flat).normalized();
}

}  // namespace

Placement PlacementOn(const SurfaceMap& map, const PlacementOptions& options,
                      const Eigen::Vector2d& tile_mm) {
  Placement placement;
  placement.scale = options.scale;
  placement.repeat = options.repeat;
  if (options.middle) placement.origin_mm = tile_mm / 2;
  placement.anchor_mm = (map.low_mm() + map.high_mm()) / 2;
  SurfacePoint anchor;
  if (options.anchor_mm) {
    anchor = map.NearestTo(*options.anchor_mm);
    placement.anchor_mm = map.MapPosition(anchor);
  } else if (options.direction) {
    double least = -1;
    for (size_t t = 0; t < map.mesh().triangles.size(); ++t) {
      const SurfacePoint middle{static_cast<int32_t>(t), Eigen::Vector3d::Constant(1.0 / 3)};
      const double distance = (map.MapPosition(middle) - placement.anchor_mm).squaredNorm();
      if (least >= 0 && distance >= least) continue;
      least = distance;
      anchor = middle;
    }
  }
  if (options.direction)
    placement.x_axis = IntoMap(map, anchor.triangle, *options.direction).value_or(placement.x_axis);
  const double turn = options.turn_deg * std::numbers::pi / 180;
  const Eigen::Vector2d x = placement.x_axis, y(-x.y(), x.x());
  placement.x_axis = Cos(turn) * x + Sin(turn) * y;
  return placement;
}

}  // namespace slicefarm::texture
