#include "common/wire/engraving/engrave_input_wire.h"

#include <cmath>
#include <utility>

#include "common/wire/options/settings_check.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

/// A surface that is folded up may be laid out far wider than it is.
constexpr double kMostMapMm = 1e9;

static_assert(v1::NORMAL_KIND_INTERPOLATED == static_cast<int>(NormalKind::kInterpolated) + 1);
static_assert(v1::AXIS_LAYOUT_HEAD_BC == static_cast<int>(AxisLayout::kHeadBc) + 1);
static_assert(v1::TOOL_KIND_EXTRUDER == static_cast<int>(ToolKind::kExtruder) + 1);
static_assert(v1::ENGRAVE_FORMAT_GCODE == static_cast<int>(EngraveFormat::kGcode) + 1);

void Put(const TextureSettings& texture, v1::TextureSettings* proto) {
  proto->set_texture(texture.texture);
  proto->set_width_mm(texture.width_mm);
  proto->set_height_mm(texture.height_mm);
  proto->set_pitch(texture.pitch);
  proto->set_anchor(texture.anchor);
  proto->set_orient(texture.orient);
  proto->set_turn_deg(texture.turn_deg);
  proto->set_scale(texture.scale);
  proto->set_once(texture.once);
  proto->set_margin_mm(texture.margin_mm);
  proto->set_engraved(texture.engraved);
  proto->set_outside(texture.outside);
}

TextureSettings Taken(const v1::TextureSettings& proto) {
  TextureSettings texture;
  texture.texture = proto.texture();
  texture.width_mm = proto.width_mm();
  texture.height_mm = proto.height_mm();
  texture.pitch = proto.pitch();
  texture.anchor = proto.anchor();
  texture.orient = proto.orient();
  texture.turn_deg = proto.turn_deg();
  texture.scale = proto.scale();
  texture.once = proto.once();
  texture.margin_mm = proto.margin_mm();
  texture.engraved = proto.engraved();
  texture.outside = proto.outside();
  return texture;
}

void Put(const EngraveLineSettings& lines, v1::EngraveLineSettings* proto) {
  proto->set_layer_height_mm(lines.layer_height_mm);
  proto->set_spacing(lines.spacing);
  proto->set_angle(lines.angle);
  proto->set_equidistant(lines.equidistant);
  proto->set_normals(EnumToProto<v1::NormalKind>(lines.normals));
  proto->set_connect(lines.connect);
  proto->set_clearance_mm(lines.clearance_mm);
  proto->set_shortest_mm(lines.shortest_mm);
  proto->set_seam(lines.seam);
}

EngraveLineSettings Taken(const v1::EngraveLineSettings& proto) {
  EngraveLineSettings lines;
  lines.layer_height_mm = proto.layer_height_mm();
  lines.spacing = proto.spacing();
  lines.angle = proto.angle();
  lines.equidistant = proto.equidistant();
  lines.normals = Known<NormalKind>(proto.normals());
  lines.connect = proto.connect();
  lines.clearance_mm = proto.clearance_mm();
  lines.shortest_mm = proto.shortest_mm();
  lines.seam = proto.seam();
  return lines;
}

void Put(const EngraveMachineSettings& machine, v1::EngraveMachineSettings* proto) {
  proto->set_axes(EnumToProto<v1::AxisLayout>(machine.axes));
  proto->set_tool(EnumToProto<v1::ToolKind>(machine.tool));
  proto->set_centre(machine.centre);
  proto->set_pivot_mm(machine.pivot_mm);
  proto->set_tilt_deg(machine.tilt_deg);
  proto->set_steepest_deg(machine.steepest_deg);
  proto->set_power(machine.power);
  proto->set_feed_mm_min(machine.feed_mm_min);
  proto->set_link_mm_min(machine.link_mm_min);
  proto->set_turn_deg_min(machine.turn_deg_min);
}

EngraveMachineSettings Taken(const v1::EngraveMachineSettings& proto) {
  EngraveMachineSettings machine;
  machine.axes = Known<AxisLayout>(proto.axes());
  machine.tool = Known<ToolKind>(proto.tool());
  machine.centre = proto.centre();
  machine.pivot_mm = proto.pivot_mm();
  machine.tilt_deg = proto.tilt_deg();
  machine.steepest_deg = proto.steepest_deg();
  machine.power = proto.power();
  machine.feed_mm_min = proto.feed_mm_min();
  machine.link_mm_min = proto.link_mm_min();
  machine.turn_deg_min = proto.turn_deg_min();
  return machine;
}

}  // namespace

absl::Status ToProto(const EngraveSettings& settings, v1::EngraveSettings* proto) {
  Put(settings.texture, proto->mutable_texture());
  Put(settings.lines, proto->mutable_lines());
  Put(settings.machine, proto->mutable_machine());
  proto->set_format(EnumToProto<v1::EngraveFormat>(settings.format));
  return absl::OkStatus();
}

absl::StatusOr<EngraveSettings> FromProto(const v1::EngraveSettings& proto) {
  if (absl::Status complete = CheckComplete(proto); !complete.ok()) return complete;
  return EngraveSettings{Taken(proto.texture()), Taken(proto.lines()), Taken(proto.machine()),
                         Known<EngraveFormat>(proto.format())};
}

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
  absl::Status status = ToProto(input.settings, proto->mutable_settings());
  status.Update(ToProto(input.solid, proto->mutable_solid()));
  status.Update(ToProto(input.surface, proto->mutable_surface()));
  return status;
}

absl::StatusOr<EngraveInput> FromProto(const v1::EngraveInput& proto) {
  absl::StatusOr<EngraveSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<SurfaceMesh> solid = FromProto(proto.solid());
  if (!solid.ok()) return Within("solid", solid.status());
  absl::StatusOr<MappedSurface> surface = FromProto(proto.surface());
  if (!surface.ok()) return Within("surface", surface.status());
  return EngraveInput{*std::move(settings), *std::move(solid), proto.image(), proto.mask(),
                      *std::move(surface)};
}

}  // namespace slicefarm
