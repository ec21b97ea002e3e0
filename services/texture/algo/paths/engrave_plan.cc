#include "services/texture/algo/paths/engrave_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::texture {
namespace {

constexpr double kLeastSpacingMm = 1e-3;
constexpr double kMostMm = 1e4;

absl::Status CheckRange(std::string_view name, double value, double least, double most) {
  if (value >= least && value <= most) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} must be from {} to {}, got {}", name, least, most, value),
                   {{"setting", std::string(name)}});
}

absl::Status CheckOptions(const EngraveOptions& options) {
  for (const absl::Status& status :
       {CheckRange("layer_height", options.layer_height_mm, kLeastSpacingMm, kMostMm),
        CheckRange("margin", options.margin_mm, 0, kMostMm),
        CheckRange("texture_scale", options.placement.scale, 1e-3, 1e3),
        CheckRange("clearance", options.clearance_mm, 0, kMostMm),
        CheckRange("shortest", options.least_run_mm, 0, kMostMm)})
    if (!status.ok()) return status;
  for (const LineStyle& style : options.lines)
    if (absl::Status status = CheckRange("spacing", style.spacing_mm, kLeastSpacingMm, kMostMm);
        !status.ok())
      return status;
  if (options.lines.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     "spacing needs a value", {{"setting", "spacing"}});
  return absl::OkStatus();
}

}  // namespace

std::vector<double> LayerHeights(double texture_mm, double layer_height_mm) {
  const auto count =
      std::max<int64_t>(1, static_cast<int64_t>(std::ceil(texture_mm / layer_height_mm - 1e-6)));
  std::vector<double> heights;
  for (int64_t i = 0; i < count; ++i)
    heights.push_back(texture_mm * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  return heights;
}

double OffsetOf(const EngraveOptions& options, double texture_mm, double height_mm) {
  if (!options.engraved) return height_mm;
  return options.outside ? height_mm - texture_mm : -height_mm;
}

absl::StatusOr<EngravePlan> PlanEngraving(SurfaceMap map, Texture texture,
                                          std::optional<HeightGrid> mask,
                                          const EngraveOptions& options) {
  if (const absl::Status status = CheckOptions(options); !status.ok()) return status;
  const double layers = texture.height_mm / options.layer_height_mm;
  if (layers > limits::kMaxLayers)
    return LimitError(Reason::kRequestTooLarge, "layers of the texture", limits::kMaxLayers,
                      static_cast<int64_t>(layers));
  std::optional<Texture> mask_texture;
  if (mask) {
    // The first and the last pixel are on the sides of the box, so the period is one pixel larger
    // than the box.
    const Eigen::Vector2d box = map.high_mm() - map.low_mm();
    mask->size_mm = {box.x() * mask->columns / std::max(mask->columns - 1, 1),
                     box.y() * mask->rows / std::max(mask->rows - 1, 1)};
    auto made = TextureOf(*std::move(mask));
    if (!made.ok()) return made.status();
    mask_texture = *std::move(made);
  }
  const Placement placement = PlacementOn(map, options.placement, texture.tile_mm);
  std::vector<double> heights = LayerHeights(texture.height_mm, options.layer_height_mm);
  return EngravePlan{std::move(map), std::move(texture), std::move(mask_texture),
                     options,        placement,          std::move(heights)};
}

}  // namespace slicefarm::texture
