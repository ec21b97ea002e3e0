#include "common/wire/engraving/engrave_input_wire.h"

#include <cmath>
#include <utility>

#include "common/wire/options/options_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

/// Largest coordinate of a map. A folded surface may be far wider after flattening.
constexpr double kMostMapMm = 1e9;

EngraveSettings WithoutImages(EngraveSettings settings) {
  settings.texture.image.clear();
  settings.texture.mask.clear();
  return settings;
}

}  // namespace

absl::Status ToProto(const SurfaceInput& surface, v1::SurfaceInput* proto) {
  proto->set_seam(surface.seam);
  return ToProto(surface.mesh, proto->mutable_mesh());
}

absl::StatusOr<SurfaceInput> FromProto(const v1::SurfaceInput& proto) {
  absl::StatusOr<SurfaceMesh> mesh = FromProto(proto.mesh());
  if (!mesh.ok()) return Within("mesh", mesh.status());
  return SurfaceInput{*std::move(mesh), proto.seam()};
}

absl::Status ToProto(const MappedSurface& surface, v1::MappedSurface* proto) {
  proto->mutable_vertex_of()->Add(surface.vertex_of.begin(), surface.vertex_of.end());
  for (const Eigen::Vector2d& p : surface.map_mm)
    for (const double c : {p.x(), p.y()}) proto->add_xy_mm(c);
  return ToProto(surface.mesh, proto->mutable_mesh());
}

absl::StatusOr<MappedSurface> FromProto(const v1::MappedSurface& proto) {
  absl::StatusOr<SurfaceMesh> mesh = FromProto(proto.mesh());
  if (!mesh.ok()) return Within("mesh", mesh.status());
  const auto points = static_cast<int>(mesh->points_mm.size());
  if (proto.vertex_of_size() != points) return Malformed("vertex_of", "not one for each point");
  if (proto.xy_mm_size() != 2 * points) return Malformed("xy_mm", "not two for each point");
  for (const int32_t vertex : proto.vertex_of())
    if (vertex < 0 || vertex >= points) return Malformed("vertex_of", "no point is there");
  for (const double c : proto.xy_mm())
    if (!(std::abs(c) <= kMostMapMm)) return Malformed("xy_mm", "is no place of a map");
  MappedSurface surface{*std::move(mesh), {proto.vertex_of().begin(), proto.vertex_of().end()}, {}};
  for (int i = 0; i < 2 * points; i += 2)
    surface.map_mm.push_back({proto.xy_mm(i), proto.xy_mm(i + 1)});
  return surface;
}

absl::Status ToProto(const EngraveInput& input, v1::EngraveInput* proto) {
  proto->set_image(input.image);
  proto->set_mask(input.mask);
  proto->set_settings(PackFields(WithoutImages(input.settings)));
  absl::Status status = ToProto(input.solid, proto->mutable_solid());
  status.Update(ToProto(input.surface, proto->mutable_surface()));
  return status;
}

absl::StatusOr<EngraveInput> FromProto(const v1::EngraveInput& proto) {
  auto settings = OptionsFromBytes<EngraveSettings>(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<SurfaceMesh> solid = FromProto(proto.solid());
  if (!solid.ok()) return Within("solid", solid.status());
  absl::StatusOr<MappedSurface> surface = FromProto(proto.surface());
  if (!surface.ok()) return Within("surface", surface.status());
  return EngraveInput{*std::move(settings), *std::move(solid), proto.image(), proto.mask(),
                      *std::move(surface)};
}

}  // namespace slicefarm
