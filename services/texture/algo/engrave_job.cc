#include "services/texture/algo/engrave_job.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "services/texture/algo/map/exact_turn.h"
#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/pattern/image_heights.h"
#include "services/texture/algo/pattern/texture_spec.h"
#include "services/texture/algo/surface/disk.h"

namespace slicefarm::texture {
namespace {

/// Returns the vector in a setting's text; nothing for an empty text.
absl::StatusOr<std::optional<Eigen::Vector3d>> VectorIn(std::string_view setting,
                                                        std::string_view text) {
  const auto xyz = NumbersOf(setting, text, 3);
  if (!xyz.ok()) return xyz.status();
  if (xyz->empty()) return std::nullopt;
  return Eigen::Vector3d((*xyz)[0], (*xyz)[1], (*xyz)[2]);
}

absl::StatusOr<Texture> TextureIn(const EngraveInput& input) {
  const TextureSettings& settings = input.settings.texture;
  if (!input.image.empty()) {
    auto heights =
        ImageHeights(input.image, {.width_mm = settings.width_mm, .height_mm = settings.height_mm});
    if (!heights.ok()) return heights.status();
    return TextureOf(*std::move(heights));
  }
  if (!input.solid.triangles.empty()) {
    const auto pitch = NumbersOf("texture_pitch", settings.pitch, 2);
    if (!pitch.ok()) return pitch.status();
    return TextureOf(input.solid, pitch->empty() ? Eigen::Vector2d(0, 0)
                                                 : Eigen::Vector2d((*pitch)[0], (*pitch)[1]));
  }
  const auto spec = ParseTextureSpec(settings.texture);
  if (!spec.ok()) return spec.status();
  auto heights = ComputedHeights(*spec);
  if (!heights.ok()) return heights.status();
  return TextureOf(*std::move(heights));
}

absl::StatusOr<std::vector<LineStyle>> StylesIn(const EngraveLineSettings& settings) {
  const auto spacings = NumbersOf("spacing", settings.spacing, 0);
  if (!spacings.ok()) return spacings.status();
  const auto angles = NumbersOf("angle", settings.angle, 0);
  if (!angles.ok()) return angles.status();
  constexpr LineStyle kStandard;
  std::vector<LineStyle> styles(std::max({spacings->size(), angles->size(), size_t{1}}));
  for (size_t i = 0; i < styles.size(); ++i)
    styles[i] = {spacings->empty() ? kStandard.spacing_mm : (*spacings)[i % spacings->size()],
                 angles->empty() ? kStandard.angle_deg : (*angles)[i % angles->size()]};
  return styles;
}

absl::StatusOr<EngraveOptions> OptionsIn(const EngraveSettings& settings) {
  const TextureSettings& texture = settings.texture;
  const EngraveLineSettings& lines = settings.lines;
  const auto anchor = VectorIn("anchor", texture.anchor);
  const auto direction = VectorIn("orient", texture.orient);
  auto styles = StylesIn(lines);
  absl::Status read = anchor.status();
  read.Update(direction.status());
  read.Update(styles.status());
  if (!read.ok()) return read;
  return EngraveOptions{.placement = {.anchor_mm = *anchor,
                                      .direction = *direction,
                                      .turn_deg = texture.turn_deg,
                                      .scale = texture.scale,
                                      .repeat = !texture.once,
                                      .middle = texture.once},
                        .layer_height_mm = lines.layer_height_mm,
                        .lines = *std::move(styles),
                        .equidistant = lines.equidistant,
                        .engraved = texture.engraved,
                        .outside = texture.outside,
                        .margin_mm = texture.margin_mm,
                        .normals = lines.normals,
                        .connect = lines.connect,
                        .clearance_mm = lines.clearance_mm,
                        .least_run_mm = lines.shortest_mm};
}

absl::StatusOr<ProgramOptions> ProgramIn(const EngraveMachineSettings& settings) {
  const auto centre = VectorIn("centre", settings.centre);
  if (!centre.ok()) return centre.status();
  ProgramOptions program;
  program.axes = {settings.axes, centre->value_or(Eigen::Vector3d::Zero()), settings.pivot_mm,
                  settings.tilt_deg};
  program.tool = settings.tool;
  program.power = settings.power;
  program.feed_mm_min = settings.feed_mm_min;
  program.link_mm_min = settings.link_mm_min;
  program.turn_deg_min = settings.turn_deg_min;
  program.steepest_deg = settings.steepest_deg;
  return program;
}

/// Checks the map, because a client may send any map. Walks over the map require a disk without
/// flipped triangles.
absl::Status CheckMap(const MappedSurface& surface) {
  if (absl::Status disk = BoundaryOfDisk(surface.mesh).status(); !disk.ok()) return disk;
  const auto& map = surface.map_mm;
  if (map.size() == surface.mesh.points_mm.size() &&
      std::ranges::all_of(surface.mesh.triangles, [&](const auto& t) {
        return ExactTurn(map[t[0]], map[t[1]], map[t[2]]) > 0;
      }))
    return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the map does not fit the surface: a triangle is flipped");
}

}  // namespace

absl::StatusOr<EngraveJob> PrepareEngraving(const EngraveInput& input) {
  if (absl::Status sound = CheckMap(input.surface); !sound.ok()) return sound;
  auto texture = TextureIn(input);
  if (!texture.ok()) return texture.status();
  std::optional<HeightGrid> mask;
  if (!input.mask.empty()) {
    auto read = ImageHeights(input.mask, {.height_mm = 1});
    if (!read.ok()) return read.status();
    mask = *std::move(read);
  }
  const auto options = OptionsIn(input.settings);
  if (!options.ok()) return options.status();
  auto program = ProgramIn(input.settings.machine);
  if (!program.ok()) return program.status();
  const MappedSurface& surface = input.surface;
  auto plan = PlanEngraving(SurfaceMap({surface.mesh, surface.vertex_of}, surface.map_mm),
                            *std::move(texture), std::move(mask), *options);
  if (!plan.ok()) return plan.status();
  program->layer_mm = plan->texture.height_mm / plan->layer_count();
  return EngraveJob{*std::move(plan), *std::move(program), input.settings.format,
                    input.settings.displaced_edge_mm};
}

}  // namespace slicefarm::texture
